#include "sketchsurfacer/ui/viewport/length_text.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

struct Unit
{
    double size; // in the base unit
    const char *name;
};

QString withUnit(double value, const Unit &unit, const QLocale &locale)
{
    const double shown = value / unit.size;
    const int digits = shown == 0.0 ? 0 : std::clamp(2 - int(std::floor(std::log10(std::abs(shown)))), 0, 3);
    QString number = locale.toString(shown, 'f', digits);
    if (number.contains(locale.decimalPoint())) {
        while (number.endsWith(locale.zeroDigit()))
            number.chop(1);
        if (number.endsWith(locale.decimalPoint()))
            number.chop(locale.decimalPoint().size());
    }
    return number + QChar(0x00a0) + QString::fromUtf8(unit.name); // not broken between number and unit
}

} // namespace

QString lengthText(double metres, const QLocale &locale)
{
    const double size = std::abs(metres);
    const Unit unit = size >= 1000.0 ? Unit{1000.0, "km"}
                      : size >= 1.0  ? Unit{1.0, "m"}
                      : size >= 0.1  ? Unit{0.01, "cm"}
                                     : Unit{0.001, "mm"};
    return withUnit(metres, unit, locale);
}

QString areaText(double squareMetres, const QLocale &locale)
{
    const double size = std::abs(squareMetres);
    const Unit unit = size >= 0.1 ? Unit{1.0, "m²"} : size >= 1e-4 ? Unit{1e-4, "cm²"} : Unit{1e-6, "mm²"};
    return withUnit(squareMetres, unit, locale);
}

double roundLength(double metres)
{
    if (!(metres > 0.0))
        return 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(metres) + 1e-12));
    for (const double step : {5.0, 2.0})
        if (step * power <= metres * (1 + 1e-12))
            return step * power;
    return power;
}

} // namespace ductus
