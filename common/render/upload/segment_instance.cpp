#include "render/upload/segment_instance.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

std::array<std::int16_t, 4> fractions(const Eigen::Vector3f &v, std::uint32_t w)
{
    const auto one = [](float x) { return std::int16_t(std::lround(32767 * std::clamp(x, -1.f, 1.f))); };
    return {one(v[0]), one(v[1]), one(v[2]), std::int16_t(w)};
}

std::array<std::uint16_t, 4> halves(const Eigen::Vector3f &colour, float opacity)
{
    const auto one = [](float x) { return Eigen::numext::bit_cast<std::uint16_t>(Eigen::half(x)); };
    return {one(colour[0]), one(colour[1]), one(colour[2]), one(opacity)};
}

} // namespace

SegmentInstance instanceOf(const SegmentData &s, std::uint32_t element)
{
    return {{s.a[0], s.a[1], s.a[2]},
            s.radiusA,
            {s.b[0], s.b[1], s.b[2]},
            s.radiusB,
            fractions(s.u, s.section),
            fractions(s.v, s.caps),
            fractions(s.clipA, 0),
            fractions(s.clipB, 0),
            halves(s.colourA, s.opacityA),
            halves(s.colourB, s.opacityB),
            element};
}

ReachInstance reachOf(const SegmentData &s)
{
    return {fractions(s.reachA, 0), fractions(s.reachB, 0)};
}

StrokeSummary summaryOf(const std::vector<SegmentData> &segments)
{
    StrokeSummary summary;
    for (const SegmentData &segment : segments) {
        const Box3 box = segmentBounds(segment).box();
        summary.box.add(box.min);
        summary.box.add(box.max);
        summary.uniformColour &= segment.colourA == segment.colourB && segment.colourA == segments[0].colourA;
        summary.uniformOpacity &= segment.opacityA == segment.opacityB;
        summary.leastOpacity = std::min({summary.leastOpacity, segment.opacityA, segment.opacityB});
        summary.sections |= 1u << segment.section;
    }
    return summary;
}

} // namespace ductus
