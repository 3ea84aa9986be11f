// "Is there a segment within a fixed distance of this point?", answered from a grid of cells of that size.
#pragma once

#include "geometry/triangle_mesh.h"

#include <cstdint>
#include <map>

namespace ductus {

struct Segment
{
    Vec3 a;
    Vec3 b;
};

double distanceToSegment(const Vec3 &point, const Segment &segment);

class SegmentIndex
{
public:
    /// \a reach: the largest distance that will be asked for; > 0.
    SegmentIndex(std::vector<Segment> segments, double reach);

    /// \a distance <= reach.
    bool isWithin(const Vec3 &point, double distance) const;

private:
    using Cell = std::array<std::int64_t, 3>;
    Cell cellOf(const Vec3 &point) const;

    std::vector<Segment> mSegments;
    double mReach = 1.0;
    std::map<Cell, std::vector<int>> mCells;
};

} // namespace ductus
