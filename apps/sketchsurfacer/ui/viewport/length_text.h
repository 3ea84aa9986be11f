// Lengths and areas in words: "12.4 mm", "0.83 m²". Three significant figures, the unit that reads best.
#pragma once

#include <QLocale>
#include <QString>

namespace ductus {

QString lengthText(double metres, const QLocale &locale = {});
QString areaText(double squareMetres, const QLocale &locale = {});

/// The largest of 1, 2, 5 times a power of ten that is at most \a metres; 0 for metres <= 0.
double roundLength(double metres);

} // namespace ductus
