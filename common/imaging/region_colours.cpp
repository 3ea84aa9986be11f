#include "imaging/region_colours.h"

#include "geometry/triangle_mesh.h"
#include "imaging/picture/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace ductus {

namespace {

// Found by a search for the largest least distance in L*a*b* as seen with three, and with each two, kinds of
// cones, at a lightness and chroma that sit well on clay; ordered so that the first few are the furthest
// apart.
constexpr std::array<Rgba, regionColourCount> palette{{
    {61, 145, 222, 255},  {243, 222, 96, 255},  {180, 40, 40, 255},   {159, 215, 201, 255},
    {124, 187, 96, 255},  {82, 96, 131, 255},   {229, 215, 250, 255}, {82, 138, 103, 255},
    {208, 103, 40, 255},  {215, 173, 250, 255}, {47, 117, 229, 255},  {124, 75, 166, 255},
    {236, 222, 187, 255}, {229, 166, 54, 255},  {159, 145, 187, 255}, {110, 110, 61, 255},
    {215, 222, 138, 255}, {40, 180, 159, 255},  {40, 110, 110, 255},  {159, 180, 131, 255},
}};

Vec3 labFromLinear(const Vec3 &rgb)
{
    Eigen::Matrix3d xyzFromRgb;
    xyzFromRgb << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920,
        0.9503041;
    const Vec3 white(0.95047, 1.0, 1.08883); // D65
    Vec3 f = (xyzFromRgb * rgb).cwiseQuotient(white);
    for (double &x : f)
        x = x > 216.0 / 24389.0 ? std::cbrt(x) : (24389.0 / 27.0 * x + 16.0) / 116.0;
    return {116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z())};
}

} // namespace

Rgba regionColour(int index)
{
    const int wrapped = (index % regionColourCount + regionColourCount) % regionColourCount;
    return palette[std::size_t(wrapped)];
}

double colourDistance(Rgba a, Rgba b)
{
    return (labFromLinear(picture::linearFromRgba(a)) - labFromLinear(picture::linearFromRgba(b))).norm();
}

Rgba asSeenByColourBlind(Rgba colour, int missingCone)
{
    // Responses of the long, medium and short cones, scaled as in the paper; the missing one is what the
    // other two imply for the colours such a person and one with full vision see alike.
    Eigen::Matrix3d lmsFromRgb;
    lmsFromRgb << 17.8824, 43.5161, 4.11935, 3.45565, 27.1554, 3.86714, 0.0299566, 0.184309, 1.46709;
    Vec3 lms = lmsFromRgb * picture::linearFromRgba(colour);
    switch (missingCone) {
    case 0:
        lms.x() = 2.02344 * lms.y() - 2.52581 * lms.z();
        break;
    case 1:
        lms.y() = 0.494207 * lms.x() + 1.24827 * lms.z();
        break;
    default:
        lms.z() = -0.395913 * lms.x() + 0.801109 * lms.y();
        break;
    }
    return picture::rgbaFromLinear(lmsFromRgb.inverse() * lms);
}

std::vector<int> assignRegionColours(int regionCount, const std::vector<std::pair<int, int>> &neighbours)
{
    std::vector<std::set<int>> around(std::size_t(std::max(0, regionCount)));
    for (const auto &[a, b] : neighbours) {
        if (a == b || a < 0 || b < 0 || a >= regionCount || b >= regionCount)
            continue;
        around[std::size_t(a)].insert(b);
        around[std::size_t(b)].insert(a);
    }
    // The most entangled first [Welsh, Powell 1967]: those that come later have fewer constraints left to
    // meet.
    std::vector<int> order(around.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = int(i);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return around[std::size_t(a)].size() > around[std::size_t(b)].size();
    });

    std::vector<int> colours(around.size(), -1);
    std::array<int, regionColourCount> uses{};
    for (int region : order) {
        std::set<int> taken;
        for (int other : around[std::size_t(region)]) {
            if (colours[std::size_t(other)] >= 0)
                taken.insert(colours[std::size_t(other)]);
        }
        // Of the free colours the least used so far, then the one furthest from the neighbours' colours.
        int best = -1;
        double bestDistance = 0.0;
        for (int colour = 0; colour < regionColourCount; ++colour) {
            if (taken.contains(colour))
                continue;
            double distance = 1e9;
            for (int other : taken)
                distance = std::min(distance, colourDistance(regionColour(colour), regionColour(other)));
            const int use = uses[std::size_t(colour)];
            const int bestUse = best < 0 ? 0 : uses[std::size_t(best)];
            if (best < 0 || use < bestUse || (use == bestUse && distance > bestDistance)) {
                best = colour;
                bestDistance = distance;
            }
        }
        if (best < 0) {
            best = regionColourCount;
            while (taken.contains(best))
                ++best;
        }
        colours[std::size_t(region)] = best;
        ++uses[std::size_t(best % regionColourCount)];
    }
    return colours;
}

} // namespace ductus
