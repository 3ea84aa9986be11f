#include "surfacing/sketch/symmetry_plane.h"

#include "strokes/resample.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace ductus {

namespace {

// Nearest of a fixed set of points within a radius, by hashing into cubes of that size.
class PointGrid
{
public:
    PointGrid(const std::vector<Vec3> &points, double radius) : mPoints(points), mRadius(radius)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            mCubes[keyOf(cubeOf(points[i]))].push_back(int(i));
    }

    int nearest(const Vec3 &query, double &distance) const
    {
        const Eigen::Vector3i cube = cubeOf(query);
        int best = -1;
        distance = mRadius;
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dz = -1; dz <= 1; ++dz) {
                    const auto it = mCubes.find(keyOf(cube + Eigen::Vector3i(dx, dy, dz)));
                    if (it == mCubes.end())
                        continue;
                    for (int i : it->second) {
                        const double d = (mPoints[std::size_t(i)] - query).norm();
                        if (d < distance) {
                            best = i;
                            distance = d;
                        }
                    }
                }
        return best;
    }

private:
    Eigen::Vector3i cubeOf(const Vec3 &p) const { return (p / mRadius).array().floor().cast<int>(); }
    static std::int64_t keyOf(const Eigen::Vector3i &c)
    {
        return (std::int64_t(c.x()) * 2097169 + c.y()) * 2097169 + c.z();
    }

    const std::vector<Vec3> &mPoints;
    double mRadius;
    std::unordered_map<std::int64_t, std::vector<int>> mCubes;
};

struct Match
{
    std::vector<double> distances;          // of matched samples
    std::vector<std::pair<int, int>> pairs; // sample, and the sample nearest to its mirror image
};

Match matchMirrorImage(const std::vector<Vec3> &samples, const PointGrid &grid, const SymmetryPlane &plane)
{
    Match match;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double distance = 0.0;
        const int other = grid.nearest(plane.mirrored(samples[i]), distance);
        if (other >= 0) {
            match.pairs.emplace_back(int(i), other);
            match.distances.push_back(distance);
        }
    }
    return match;
}

// The plane that best halves the matched pairs: normal from the sum of outer products of their differences.
SymmetryPlane refined(const std::vector<Vec3> &samples, const Match &match, const SymmetryPlane &old)
{
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto &[i, j] : match.pairs) {
        const Vec3 d = samples[std::size_t(i)] - samples[std::size_t(j)];
        spread += d * d.transpose();
    }
    SymmetryPlane plane;
    plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
    if (std::abs(plane.normal.dot(old.normal)) < 0.9) // pairs across the plane are too few to say
        plane.normal = old.normal;
    if (plane.normal.dot(old.normal) < 0.0)
        plane.normal = -plane.normal;
    for (const auto &[i, j] : match.pairs)
        plane.offset += plane.normal.dot(samples[std::size_t(i)] + samples[std::size_t(j)]) /
                        (2.0 * double(match.pairs.size()));
    return plane;
}

// Axis-aligned to within a fraction of a degree means axis-aligned: mirror tools work in axes.
SymmetryPlane snappedToAxis(SymmetryPlane plane)
{
    for (int k = 0; k < 3; ++k)
        if (std::abs(plane.normal[k]) > 0.99995)
            plane.normal = Vec3::Unit(k) * (plane.normal[k] > 0 ? 1.0 : -1.0);
    return plane;
}

} // namespace

std::optional<SymmetryProposal> detectSymmetry(const StrokeSet &strokes, const SymmetryOptions &options)
{
    const double diagonal = strokes.box().diagonal();
    if (!(diagonal > 0.0))
        return std::nullopt;
    std::vector<Vec3> samples;
    Vec3 centroid = Vec3::Zero();
    for (const Stroke &stroke : strokes.strokes)
        for (const Vec3 &p : resampled(stroke.points, 0.01 * diagonal))
            samples.push_back(p);
    if (samples.size() < 20)
        return std::nullopt;
    for (const Vec3 &p : samples)
        centroid += p / double(samples.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3 &p : samples)
        spread += (p - centroid) * (p - centroid).transpose();
    const Eigen::Matrix3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();

    std::vector<SymmetryPlane> candidates;
    for (int k = 0; k < 3; ++k)
        for (const Vec3 &middle : {strokes.box().centre(), centroid})
            for (const Vec3 &normal : {Vec3(Vec3::Unit(k)), Vec3(principal.col(k))})
                candidates.push_back({normal, normal.dot(middle)});

    // First a loose radius to find the way, then the tolerance that counts.
    const PointGrid loose(samples, 5.0 * options.tolerance * diagonal), strict(samples, options.tolerance * diagonal);
    std::optional<SymmetryProposal> best;
    for (SymmetryPlane plane : candidates) {
        for (int round = 0; round < 8; ++round) {
            const Match match = matchMirrorImage(samples, round < 5 ? loose : strict, plane);
            if (match.pairs.size() < samples.size() / 4)
                break;
            plane = refined(samples, match, plane);
        }
        plane = snappedToAxis(plane);
        Match match = matchMirrorImage(samples, strict, plane);
        const double share = double(match.pairs.size()) / double(samples.size());
        if (share < options.neededShare || (best && share <= best->matchedShare))
            continue;
        std::nth_element(match.distances.begin(), match.distances.begin() + std::ptrdiff_t(match.distances.size() / 2),
                         match.distances.end());
        best = SymmetryProposal{plane, share, match.distances[match.distances.size() / 2]};
    }
    return best;
}

SymmetryPlane towardsFullerSide(const SymmetryPlane &plane, const StrokeSet &strokes)
{
    double kept = 0.0, other = 0.0;
    for (const Stroke &stroke : strokes.strokes)
        for (std::size_t i = 1; i < stroke.points.size(); ++i) {
            const double length = (stroke.points[i] - stroke.points[i - 1]).norm();
            const double side = plane.signedDistance(0.5 * (stroke.points[i] + stroke.points[i - 1]));
            (side >= 0.0 ? kept : other) += length;
        }
    return other > kept ? SymmetryPlane{-plane.normal, -plane.offset} : plane;
}

StrokeSet keptHalf(const StrokeSet &strokes, const SymmetryPlane &plane)
{
    // Points this close to the plane count as in it: mirrored pairs of strokes lie there twice, slightly apart.
    const double tolerance = 1e-4 * strokes.box().diagonal();
    StrokeSet result = strokes;
    result.strokes.clear();
    for (const Stroke &stroke : strokes.strokes) {
        Stroke piece = stroke;
        const auto clear = [&] {
            piece.points.clear();
            piece.pressure.clear();
            piece.timeSeconds.clear();
        };
        const auto flush = [&] {
            if (piece.points.size() >= 2 || (piece.points.size() == 1 && stroke.points.size() == 1))
                result.strokes.push_back(piece);
            clear();
        };
        clear();
        const auto append = [&](std::size_t i, double t) { // between points i and i + 1
            const auto mix = [&](const auto &values) {
                using T = typename std::decay_t<decltype(values)>::value_type;
                return t == 0.0 ? values[i] : T((1.0 - t) * values[i] + t * values[i + 1]);
            };
            piece.points.push_back(mix(stroke.points));
            if (!stroke.pressure.empty())
                piece.pressure.push_back(mix(stroke.pressure));
            if (!stroke.timeSeconds.empty())
                piece.timeSeconds.push_back(mix(stroke.timeSeconds));
        };
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const double here = plane.signedDistance(stroke.points[i]);
            if (here >= -tolerance)
                append(i, 0.0);
            if (i + 1 == stroke.points.size())
                break;
            const double next = plane.signedDistance(stroke.points[i + 1]);
            if ((here >= -tolerance) == (next >= -tolerance))
                continue;
            const double t = std::clamp(here / (here - next), 0.0, 1.0);
            if (t > 0.0 && t < 1.0)
                append(i, t);
            if (next < -tolerance)
                flush();
        }
        flush();
    }
    return result;
}

StrokeSet withMirrorImage(const StrokeSet &half, const SymmetryPlane &plane)
{
    StrokeSet whole = half;
    for (Stroke stroke : half.strokes) {
        for (Vec3 &p : stroke.points)
            p = plane.mirrored(p);
        whole.strokes.push_back(std::move(stroke));
    }
    return whole;
}

} // namespace ductus
