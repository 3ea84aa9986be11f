// PressureCurve: how hard the pen is pressed against how hard it counts. A smooth, never falling curve
// through four points the user drags: both ends and two between.
#pragma once

#include <QPointF>
#include <QString>
#include <array>

namespace ductus {

class PressureCurve
{
public:
    static constexpr int pointCount = 4;

    /// The straight line: pressure as it comes.
    PressureCurve();

    /// What \a pressure (0..1) counts as, 0..1. Monotone cubic Hermite interpolation [Fritsch, Carlson 1980].
    double map(double pressure) const;

    const std::array<QPointF, pointCount> &points() const { return mPoints; }
    /// Moves a point, kept in the unit square and between its neighbours in both directions. Ends move along
    /// the edges x = 0 and x = 1 only in y, or along y = 0 and y = 1 in x: the dead zones.
    void movePoint(int index, QPointF to);

    /// "0,0 0.3,0.3 ..." and back; the straight line for anything else.
    QString toText() const;
    static PressureCurve fromText(const QString &text);

    bool operator==(const PressureCurve &other) const = default;

private:
    std::array<QPointF, pointCount> mPoints;
};

} // namespace ductus
