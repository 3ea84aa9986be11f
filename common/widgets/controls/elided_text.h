#pragma once

#include <QFont>
#include <QString>

namespace ductus {

/// \a text broken between words into at most \a lines lines of \a width pixels in \a font, joined by '\n';
/// what does not fit ends in an ellipsis.
QString elidedLines(const QString &text, const QFont &font, int width, int lines);

} // namespace ductus
