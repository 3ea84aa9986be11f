#include "support/segment_index.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>

namespace ductus {

double distanceToSegment(const Vec3 &point, const Segment &segment)
{
    const Vec3 direction = segment.b - segment.a;
    const double square = direction.squaredNorm();
    const double t = square > 0.0 ? std::clamp(direction.dot(point - segment.a) / square, 0.0, 1.0) : 0.0;
    return (segment.a + t * direction - point).norm();
}

SegmentIndex::SegmentIndex(std::vector<Segment> segments, double reach)
    : mSegments(std::move(segments)), mReach(reach)
{
    DUCTUS_ASSERT(reach > 0.0);
    for (std::size_t i = 0; i < mSegments.size(); ++i) {
        // Every cell the segment passes is within one cell of a point of a walk at half steps.
        const double length = (mSegments[i].b - mSegments[i].a).norm();
        const int steps = std::max(1, int(std::ceil(2.0 * length / reach)));
        for (int k = 0; k <= steps; ++k) {
            std::vector<int> &cell =
                mCells[cellOf(mSegments[i].a + (mSegments[i].b - mSegments[i].a) * (double(k) / steps))];
            if (cell.empty() || cell.back() != int(i))
                cell.push_back(int(i));
        }
    }
}

bool SegmentIndex::isWithin(const Vec3 &point, double distance) const
{
    DUCTUS_ASSERT(distance <= mReach);
    // Two cells around: one for the distance asked, one for the half steps of the walk.
    const Cell centre = cellOf(point);
    for (std::int64_t x = -2; x <= 2; ++x)
        for (std::int64_t y = -2; y <= 2; ++y)
            for (std::int64_t z = -2; z <= 2; ++z) {
                const auto it = mCells.find({centre[0] + x, centre[1] + y, centre[2] + z});
                if (it == mCells.end())
                    continue;
                for (const int i : it->second)
                    if (distanceToSegment(point, mSegments[std::size_t(i)]) <= distance)
                        return true;
            }
    return false;
}

SegmentIndex::Cell SegmentIndex::cellOf(const Vec3 &point) const
{
    Cell cell;
    for (int k = 0; k < 3; ++k)
        cell[k] = std::int64_t(std::floor(point[k] / mReach));
    return cell;
}

} // namespace ductus
