#include "strokes/resample.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace ductus {

namespace {

// Where an even sample falls on the original polyline.
struct PolylinePosition
{
    std::size_t segment;
    double t; // 0..1 within the segment
};

std::vector<PolylinePosition> evenPositions(const std::vector<Vec3> &points, double step)
{
    DUCTUS_ASSERT(step > 0.0);
    const double length = polylineLength(points);
    if (points.empty())
        return {};
    if (!(length > 0.0))
        return {{0, 0.0}};
    const int pieces = std::max(1, int(std::ceil(length / step - 1e-9)));
    std::vector<PolylinePosition> positions;
    positions.reserve(std::size_t(pieces) + 1);
    std::size_t segment = 0;
    double before = 0.0; // arc length at the start of `segment`
    for (int i = 0; i <= pieces; ++i) {
        const double target = length * i / pieces;
        double segmentLength = (points[segment + 1] - points[segment]).norm();
        while (segment + 2 < points.size() && before + segmentLength < target) {
            before += segmentLength;
            ++segment;
            segmentLength = (points[segment + 1] - points[segment]).norm();
        }
        const double t = segmentLength > 0.0 ? std::clamp((target - before) / segmentLength, 0.0, 1.0) : 0.0;
        positions.push_back({segment, i == pieces ? 1.0 : t});
    }
    return positions;
}

template <typename T>
std::vector<T> interpolated(const std::vector<T> &values, const std::vector<PolylinePosition> &positions)
{
    std::vector<T> result;
    result.reserve(positions.size());
    for (const PolylinePosition &p : positions) {
        if (p.t == 0.0 || p.segment + 1 >= values.size())
            result.push_back(values[p.segment]);
        else if (p.t == 1.0)
            result.push_back(values[p.segment + 1]);
        else
            result.push_back(T((1.0 - p.t) * values[p.segment] + p.t * values[p.segment + 1]));
    }
    return result;
}

std::size_t hashOfPoints(const std::vector<Vec3> &points, bool backwards)
{
    std::size_t hash = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 &p = points[backwards ? points.size() - 1 - i : i];
        for (int k = 0; k < 3; ++k)
            hash = hash * 1099511628211ull + std::hash<double>()(p[k]);
    }
    return hash;
}

} // namespace

std::vector<Vec3> resampled(const std::vector<Vec3> &points, double step)
{
    return interpolated(points, evenPositions(points, step));
}

Stroke resampled(const Stroke &stroke, double step)
{
    const std::vector<PolylinePosition> positions = evenPositions(stroke.points, step);
    Stroke result = stroke;
    result.points = interpolated(stroke.points, positions);
    if (!stroke.pressure.empty())
        result.pressure = interpolated(stroke.pressure, positions);
    if (!stroke.timeSeconds.empty())
        result.timeSeconds = interpolated(stroke.timeSeconds, positions);
    return result;
}

StrokeSet cleaned(const StrokeSet &set)
{
    StrokeSet result = set;
    result.strokes.clear();
    std::unordered_multimap<std::size_t, std::size_t> seen;
    for (const Stroke &stroke : set.strokes) {
        Stroke kept = stroke;
        kept.points.clear();
        kept.pressure.clear();
        kept.timeSeconds.clear();
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            if (!kept.points.empty() && kept.points.back() == stroke.points[i])
                continue;
            kept.points.push_back(stroke.points[i]);
            if (!stroke.pressure.empty())
                kept.pressure.push_back(stroke.pressure[i]);
            if (!stroke.timeSeconds.empty())
                kept.timeSeconds.push_back(stroke.timeSeconds[i]);
        }
        if (kept.points.size() < 2)
            continue;
        bool duplicate = false;
        for (bool backwards : {false, true}) {
            const auto [first, last] = seen.equal_range(hashOfPoints(kept.points, backwards));
            for (auto it = first; it != last && !duplicate; ++it) {
                const std::vector<Vec3> &other = result.strokes[it->second].points;
                duplicate = backwards ? std::equal(other.rbegin(), other.rend(), kept.points.begin(),
                                                   kept.points.end())
                                      : other == kept.points;
            }
        }
        if (duplicate)
            continue;
        seen.emplace(hashOfPoints(kept.points, false), result.strokes.size());
        result.strokes.push_back(std::move(kept));
    }
    return result;
}

} // namespace ductus
