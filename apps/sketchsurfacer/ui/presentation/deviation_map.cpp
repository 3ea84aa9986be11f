#include "sketchsurfacer/ui/presentation/deviation_map.h"

#include "base/parallel.h"
#include "geometry/nearest.h"
#include "geometry/point_tree.h"
#include "sketchsurfacer/ui/viewport/length_text.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr Rgba neutral{176, 174, 170, 255};
constexpr double reachShare = 0.03; // of the diagonal: how far from a stroke the surface takes its colour

std::uint8_t encoded(double linear)
{
    const double c = std::clamp(linear, 0.0, 1.0);
    return std::uint8_t(
        std::lround(255.0 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
}

// sRGB of a colour in Oklab [Ottosson 2020].
Rgba fromOklab(double lightness, double a, double b)
{
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), 255};
}

Rgba blend(Rgba from, Rgba to, double share)
{
    Rgba mixed = from;
    for (std::size_t c = 0; c < 3; ++c)
        mixed[c] = std::uint8_t(std::lround(from[c] + share * (double(to[c]) - double(from[c]))));
    return mixed;
}

bool carriesSurface(const Stroke &stroke)
{
    return stroke.role == StrokeRole::Surface || stroke.role == StrokeRole::Boundary;
}

// The least of 1, 2, 5 times a power of ten that is not below \a metres.
double roundedUp(double metres)
{
    const double below = roundLength(metres);
    for (const double factor : {1.0, 2.0, 2.5, 5.0})
        if (below * factor >= metres * (1 - 1e-9))
            return roundLength(below * factor * (1 + 1e-9));
    return metres;
}

} // namespace

Rgba deviationColour(double share)
{
    // Evenly rising lightness; hue from blue over green to yellow.
    static constexpr double stops[5][3] = {{0.40, -0.010, -0.115},
                                           {0.53, -0.065, -0.065},
                                           {0.66, -0.110, 0.035},
                                           {0.79, -0.075, 0.125},
                                           {0.92, 0.000, 0.160}};
    const double x = std::clamp(share, 0.0, 1.0) * 4.0;
    const int i = std::min(3, int(x));
    const double t = x - i;
    double lab[3];
    for (int k = 0; k < 3; ++k)
        lab[k] = stops[i][k] + t * (stops[i + 1][k] - stops[i][k]);
    return fromOklab(lab[0], lab[1], lab[2]);
}

DeviationMap deviationMap(const TriangleMesh &surface, const std::vector<int> &triangleRegions,
                          int regionCount, const StrokeSet &strokes, const JobControl &control)
{
    DeviationMap map;
    map.strokeDistance.resize(strokes.strokes.size());
    map.regionDeviation.assign(std::size_t(regionCount), -1.0);
    if (surfaceArea(surface) <= 0.0)
        return map;
    const NearestOnMesh nearest(surface);
    std::vector<Vec3> feet; // of all points, on the surface
    std::vector<double> distances;
    std::vector<double> sum(std::size_t(regionCount), 0.0), count(std::size_t(regionCount), 0.0);
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
        const Stroke &stroke = strokes.strokes[i];
        if (!carriesSurface(stroke))
            continue;
        for (const Vec3 &p : stroke.points) {
            const NearestPoint near = nearest.nearest(p);
            map.strokeDistance[i].push_back(near.distance);
            feet.push_back(near.point);
            distances.push_back(near.distance);
            const auto region = std::size_t(triangleRegions[std::size_t(near.triangle)]);
            sum[region] += near.distance;
            count[region] += 1.0;
        }
        if (control.isCancelled())
            return map;
    }
    for (std::size_t r = 0; r < sum.size(); ++r)
        if (count[r] > 0.0)
            map.regionDeviation[r] = sum[r] / count[r];
    if (distances.empty())
        return map;
    std::vector<double> all = distances;
    const auto high = all.begin() + std::ptrdiff_t(0.98 * double(all.size() - 1));
    std::nth_element(all.begin(), high, all.end());
    const double unit = strokes.metresPerUnit;
    map.largest = roundedUp(std::max(*high, 1e-6 * strokes.box().diagonal()) * unit) / unit;

    const double reach = reachShare * strokes.box().diagonal();
    const PointTree tree(std::move(feet));
    map.vertexColours.assign(surface.vertices.size(), neutral);
    parallelChunks(surface.vertices.size(), 256, [&](std::size_t begin, std::size_t end) {
        if (control.isCancelled())
            return;
        for (std::size_t v = begin; v < end; ++v) {
            double weights = 0.0, mean = 0.0, closest = reach;
            for (const int i : tree.within(surface.vertices[v], reach)) {
                const double d2 = (tree.points()[std::size_t(i)] - surface.vertices[v]).squaredNorm();
                if (d2 >= reach * reach)
                    continue;
                const double w = std::exp(-9.0 * d2 / (reach * reach));
                weights += w;
                mean += w * distances[std::size_t(i)];
                closest = std::min(closest, std::sqrt(d2));
            }
            if (weights > 0.0)
                map.vertexColours[v] = blend(deviationColour(mean / weights / map.largest), neutral,
                                             std::pow(closest / reach, 1.5));
        }
    });
    return map;
}

} // namespace ductus
