// The words on the bundled samples' cards in the language of the app. They are kept in English beside the
// samples (resources/samples/*.json).
#pragma once

#include <QString>

namespace ductus {

/// A title or a lesson of a bundled sample; unchanged if it is none.
QString sampleWords(const QString &english);

} // namespace ductus
