#include "document/settings/pressure_curve.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double closest = 0.02; // of neighbours in x

// Tangents that keep the cubic from overshooting: none where the slope changes its sign or vanishes,
// otherwise the harmonic mean of the slopes at both sides.
double tangent(double slopeBefore, double slopeAfter)
{
    if (slopeBefore * slopeAfter <= 0.0)
        return 0.0;
    return 2.0 * slopeBefore * slopeAfter / (slopeBefore + slopeAfter);
}

} // namespace

PressureCurve::PressureCurve()
{
    for (int i = 0; i < pointCount; ++i)
        mPoints[std::size_t(i)] = QPointF(i / double(pointCount - 1), i / double(pointCount - 1));
}

double PressureCurve::map(double pressure) const
{
    const auto &p = mPoints;
    if (!(pressure > p.front().x()))
        return p.front().y();
    if (pressure >= p.back().x())
        return p.back().y();
    std::size_t i = 0;
    while (i + 2 < p.size() && pressure >= p[i + 1].x())
        ++i;
    const auto slope = [&](std::size_t k) { return (p[k + 1].y() - p[k].y()) / (p[k + 1].x() - p[k].x()); };
    const double here = slope(i);
    const double m0 = i == 0 ? here : tangent(slope(i - 1), here);
    const double m1 = i + 2 == p.size() ? here : tangent(here, slope(i + 1));
    const double h = p[i + 1].x() - p[i].x();
    const double t = (pressure - p[i].x()) / h;
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double y = (2 * t3 - 3 * t2 + 1) * p[i].y() + (t3 - 2 * t2 + t) * h * m0 +
                     (-2 * t3 + 3 * t2) * p[i + 1].y() + (t3 - t2) * h * m1;
    return std::clamp(y, 0.0, 1.0);
}

void PressureCurve::movePoint(int index, QPointF to)
{
    if (index < 0 || index >= pointCount || !std::isfinite(to.x()) || !std::isfinite(to.y()))
        return;
    auto &p = mPoints;
    const auto i = std::size_t(index);
    const double lowX = i == 0 ? 0.0 : p[i - 1].x() + closest;
    const double highX = i + 1 == p.size() ? 1.0 : p[i + 1].x() - closest;
    const double lowY = i == 0 ? 0.0 : p[i - 1].y();
    const double highY = i + 1 == p.size() ? 1.0 : p[i + 1].y();
    QPointF moved(std::clamp(to.x(), lowX, highX), std::clamp(to.y(), lowY, highY));
    // An end lies on two edges of the square; it keeps to the one it is nearer to.
    if (i == 0)
        moved.x() < moved.y() ? moved.setX(0.0) : moved.setY(0.0);
    if (i + 1 == p.size())
        1.0 - moved.x() < 1.0 - moved.y() ? moved.setX(1.0) : moved.setY(1.0);
    p[i] = moved;
}

QString PressureCurve::toText() const
{
    QStringList texts;
    for (const QPointF &point : mPoints)
        texts << QStringLiteral("%1,%2")
                     .arg(point.x(), 0, 'g', QLocale::FloatingPointShortest)
                     .arg(point.y(), 0, 'g', QLocale::FloatingPointShortest);
    return texts.join(QLatin1Char(' '));
}

PressureCurve PressureCurve::fromText(const QString &text)
{
    const QStringList texts = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (texts.size() != pointCount)
        return {};
    PressureCurve curve;
    for (int i = 0; i < pointCount; ++i) {
        const QStringList pair = texts[i].split(QLatin1Char(','));
        bool isX = false;
        bool isY = false;
        if (pair.size() != 2)
            return {};
        const QPointF point(pair[0].toDouble(&isX), pair[1].toDouble(&isY));
        const auto isShare = [](double v) { return v >= 0.0 && v <= 1.0; };
        if (!isX || !isY || !isShare(point.x()) || !isShare(point.y()))
            return {};
        curve.mPoints[std::size_t(i)] = point;
    }
    for (std::size_t i = 1; i < curve.mPoints.size(); ++i) {
        if (curve.mPoints[i].x() <= curve.mPoints[i - 1].x() ||
            curve.mPoints[i].y() < curve.mPoints[i - 1].y())
            return {};
    }
    return curve;
}

} // namespace ductus
