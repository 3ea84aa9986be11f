#include "surfacing/sketch/stray_strokes.h"

#include "geometry/triangle_mesh.h"

#include <algorithm>

namespace ductus {

namespace {

Box3 boxOf(const Stroke &stroke)
{
    Box3 box;
    for (const Vec3 &p : stroke.points)
        box.add(p);
    return box;
}

bool isWithin(double distance, const Stroke &dab, const Stroke &other)
{
    for (const Vec3 &p : dab.points)
        for (const Vec3 &q : other.points)
            if ((p - q).squaredNorm() < distance * distance)
                return true;
    return false;
}

} // namespace

StraysFound withStraysIgnored(const StrokeSet &strokes, const StrayOptions &options)
{
    // Which strokes are small depends on the box of the others: the large ones first, the smaller ones
    // against them.
    std::vector<Box3> boxes;
    for (const Stroke &stroke : strokes.strokes)
        boxes.push_back(boxOf(stroke));
    std::vector<std::size_t> order(boxes.size());
    for (std::size_t s = 0; s < order.size(); ++s)
        order[s] = s;
    const auto extent = [&](std::size_t s) { return boxes[s].isEmpty() ? 0.0 : boxes[s].diagonal(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return extent(a) > extent(b); });
    Box3 body;
    std::vector<std::size_t> dabs;
    std::vector<char> isDab(boxes.size(), 0);
    for (std::size_t s : order) {
        const bool isSmall = !body.isEmpty() && extent(s) < options.largestExtent * body.diagonal();
        if (isSmall && strokes.strokes[s].role == StrokeRole::Surface) {
            dabs.push_back(s);
            isDab[s] = 1;
        } else {
            for (const Vec3 &p : strokes.strokes[s].points)
                body.add(p);
        }
    }

    StraysFound found{strokes, 0};
    if (dabs.empty() || double(dabs.size()) > options.largestShare * double(boxes.size()))
        return found;
    const double distance = options.leastDistance * body.diagonal();
    for (std::size_t dab : dabs) {
        bool isAlone = true;
        for (std::size_t s = 0; s < boxes.size() && isAlone; ++s)
            isAlone = isDab[s] || !isWithin(distance, strokes.strokes[dab], strokes.strokes[s]);
        if (isAlone) {
            found.strokes.strokes[dab].role = StrokeRole::Ignored;
            ++found.count;
        }
    }
    return found;
}

} // namespace ductus
