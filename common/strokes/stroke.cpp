#include "strokes/stroke.h"

namespace ductus {

int StrokeSet::pointCount() const
{
    std::size_t count = 0;
    for (const Stroke &s : strokes)
        count += s.points.size();
    return int(count);
}

Box3 StrokeSet::box() const
{
    Box3 box;
    for (const Stroke &s : strokes)
        for (const Vec3 &p : s.points)
            box.add(p);
    return box;
}

std::vector<Vec3> StrokeSet::allPoints() const
{
    std::vector<Vec3> points;
    points.reserve(std::size_t(pointCount()));
    for (const Stroke &s : strokes)
        points.insert(points.end(), s.points.begin(), s.points.end());
    return points;
}

double polylineLength(const std::vector<Vec3> &points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    return length;
}

} // namespace ductus
