#include "imaging/picture/visibility.h"

#include <algorithm>
#include <cmath>

namespace ductus::picture {

namespace {

double cross(const Eigen::Vector2d &u, const Eigen::Vector2d &v)
{
    return u.x() * v.y() - u.y() * v.x();
}

// On which side of the line from p to q a sample lies. Whichever way round two triangles run their common
// edge, they compute the same number with opposite signs, and a sample exactly on it belongs to one of them:
// none is lost between them, none is drawn twice.
class EdgeFunction
{
public:
    EdgeFunction(const Eigen::Vector2d &p, const Eigen::Vector2d &q)
        : mForward(p.y() != q.y() ? p.y() < q.y() : p.x() < q.x()), mStart(mForward ? p : q),
          mDirection(mForward ? Eigen::Vector2d(q - p) : Eigen::Vector2d(p - q))
    {
    }

    double operator()(const Eigen::Vector2d &s) const
    {
        const double value = cross(mDirection, s - mStart);
        return mForward ? value : -value;
    }

    bool isInside(double value) const { return mForward ? value >= 0.0 : value > 0.0; }

private:
    bool mForward;
    Eigen::Vector2d mStart, mDirection;
};

struct TileRange
{
    int left, top, right, bottom; // inclusive; empty if left > right or top > bottom
};

TileRange tilesOf(const Eigen::Vector2d &min, const Eigen::Vector2d &max, double tile, int columns, int rows)
{
    const auto index = [tile](double x, int count) {
        return int(std::clamp(std::floor(x / tile), -1.0, double(count)));
    };
    return {std::max(0, index(min.x(), columns)), std::max(0, index(min.y(), rows)),
            std::min(columns - 1, index(max.x(), columns)), std::min(rows - 1, index(max.y(), rows))};
}

// Sorts things into tiles: counts, then fills in order, so that each tile's list ascends.
template <typename RangeOf>
void sortIntoTiles(std::size_t count, int columns, int rows, const RangeOf &rangeOf,
                   std::vector<std::size_t> &begin, std::vector<std::int32_t> &lists)
{
    begin.assign(std::size_t(columns) * std::size_t(rows) + 1, 0);
    const auto forTiles = [&](std::size_t i, const auto &body) {
        const TileRange range = rangeOf(i);
        for (int y = range.top; y <= range.bottom; ++y) {
            for (int x = range.left; x <= range.right; ++x)
                body(std::size_t(y) * std::size_t(columns) + std::size_t(x));
        }
    };
    for (std::size_t i = 0; i < count; ++i)
        forTiles(i, [&](std::size_t tile) { ++begin[tile + 1]; });
    for (std::size_t tile = 1; tile < begin.size(); ++tile)
        begin[tile] += begin[tile - 1];
    lists.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
        forTiles(i, [&](std::size_t tile) { lists[next[tile]++] = std::int32_t(i); });
}

} // namespace

bool hitTube(const Vec3 &a, const Vec3 &b, double radius, const Vec3 &direction, TubeHit &hit)
{
    // The first of three entries: the cylinder between the ends and the balls around them.
    bool found = false;
    const auto offer = [&](double depth, const Vec3 &axisPoint) {
        if (depth > 0.0 && (!found || depth < hit.depth)) {
            found = true;
            hit.depth = depth;
            hit.normal = (depth * direction - axisPoint) / radius;
        }
    };
    const auto tryBall = [&](const Vec3 &centre) {
        // |t d - c| = r
        const double dd = direction.squaredNorm();
        const double dc = direction.dot(centre);
        const double root = dc * dc - dd * (centre.squaredNorm() - radius * radius);
        if (root >= 0.0)
            offer((dc - std::sqrt(root)) / dd, centre);
    };
    const Vec3 axis = b - a;
    const double length = axis.norm();
    if (length > 1e-12) {
        // The same across the axis: |t d' - a'| = r with the parts of d and a perpendicular to it.
        const Vec3 u = axis / length;
        const Vec3 d = direction - direction.dot(u) * u;
        const Vec3 c = a - a.dot(u) * u;
        const double dd = d.squaredNorm();
        const double dc = d.dot(c);
        const double root = dc * dc - dd * (c.squaredNorm() - radius * radius);
        if (root < 0.0)
            return false; // the balls lie within the endless cylinder
        if (dd > 1e-18) {
            const double t = (dc - std::sqrt(root)) / dd;
            const double along = (t * direction - a).dot(u);
            if (along >= 0.0 && along <= length)
                offer(t, a + along * u);
        }
        tryBall(b);
    }
    tryBall(a);
    return found;
}

Visibility::Visibility(const Stage &stage, const Camera &camera, int width, int height, int supersampling)
    : mStage(stage), mCamera(camera), mSupersampling(supersampling),
      mColumns((width + tilePixels - 1) / tilePixels), mRows((height + tilePixels - 1) / tilePixels)
{
    mTriangles.reserve(stage.triangles.size());
    for (const StageTriangle &triangle : stage.triangles) {
        ScreenTriangle screen;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p = camera.toEye(triangle.corners[k]);
            screen.points[k] = camera.project(p);
            screen.inverseDepth[k] = 1.0 / p.z();
        }
        screen.area = cross(screen.points[1] - screen.points[0], screen.points[2] - screen.points[0]);
        mTriangles.push_back(screen);
    }
    mTubes.reserve(stage.tubes.size());
    for (const StageTube &tube : stage.tubes) {
        ScreenTube screen;
        screen.ends[0] = camera.toEye(tube.a);
        screen.ends[1] = camera.toEye(tube.b);
        // Thinner lines than a pixel would come and go between samples.
        const double pixel =
            supersampling * 0.5 * (screen.ends[0].z() + screen.ends[1].z()) / camera.focalSamples;
        screen.radius = std::max(tube.radius, (tube.isCrease ? 0.62 : 0.7) * pixel);
        // A crease lies in the surface; in a hollow the flanks stand in front of it by a few pixels.
        screen.visibleBehind = tube.isCrease ? 3.0 * screen.radius : tube.visibleBehind;
        screen.boxMin.setConstant(1e300);
        screen.boxMax.setConstant(-1e300);
        for (const Vec3 &end : screen.ends) {
            const Eigen::Vector2d centre = camera.project(end);
            // The outline of a ball off the axis is an ellipse, a little longer than its radius tells.
            const double off = std::hypot(end.x(), end.y()) / end.z();
            const double reach = camera.focalSamples * screen.radius * (1.0 + off * off) /
                                     std::max(1e-6, end.z() - screen.radius) +
                                 1.0;
            screen.boxMin = screen.boxMin.cwiseMin(centre - Eigen::Vector2d::Constant(reach));
            screen.boxMax = screen.boxMax.cwiseMax(centre + Eigen::Vector2d::Constant(reach));
        }
        mTubes.push_back(screen);
    }
    bin();
}

void Visibility::bin()
{
    const double tile = tileSamples();
    sortIntoTiles(
        mTriangles.size(), mColumns, mRows,
        [&](std::size_t i) {
            const auto &p = mTriangles[i].points;
            return tilesOf(p[0].cwiseMin(p[1]).cwiseMin(p[2]), p[0].cwiseMax(p[1]).cwiseMax(p[2]), tile,
                           mColumns, mRows);
        },
        mTriangleBegin, mTileTriangles);
    sortIntoTiles(
        mTubes.size(), mColumns, mRows,
        [&](std::size_t i) { return tilesOf(mTubes[i].boxMin, mTubes[i].boxMax, tile, mColumns, mRows); },
        mTubeBegin, mTileTubes);
}

void Visibility::traceTile(int column, int row, std::vector<Sample> &samples) const
{
    const int side = tileSamples();
    samples.assign(std::size_t(side) * std::size_t(side), Sample());
    const std::size_t tile = std::size_t(row) * std::size_t(mColumns) + std::size_t(column);
    for (std::size_t i = mTriangleBegin[tile]; i < mTriangleBegin[tile + 1]; ++i)
        traceTriangle(mTileTriangles[i], column * side, row * side, samples);
    for (std::size_t i = mTubeBegin[tile]; i < mTubeBegin[tile + 1]; ++i)
        traceTube(mTileTubes[i], column * side, row * side, samples);
}

void Visibility::traceTriangle(int triangle, int left, int top, std::vector<Sample> &samples) const
{
    const ScreenTriangle &screen = mTriangles[std::size_t(triangle)];
    if (screen.area == 0.0)
        return; // seen from the side
    const int side = tileSamples();
    const bool flipped = screen.area < 0.0;
    const Eigen::Vector2d &p = screen.points[0];
    const Eigen::Vector2d &q = screen.points[flipped ? 2 : 1];
    const Eigen::Vector2d &r = screen.points[flipped ? 1 : 2];
    const double zp = screen.inverseDepth[0];
    const double zq = screen.inverseDepth[flipped ? 2 : 1];
    const double zr = screen.inverseDepth[flipped ? 1 : 2];
    const double area = std::abs(screen.area);
    const EdgeFunction edgeP(q, r), edgeQ(r, p), edgeR(p, q);

    // Samples sit at the middle of their cells.
    const Eigen::Vector2d low = p.cwiseMin(q).cwiseMin(r), high = p.cwiseMax(q).cwiseMax(r);
    const int x0 = int(std::max(0.0, std::ceil(low.x() - 0.5 - left)));
    const int y0 = int(std::max(0.0, std::ceil(low.y() - 0.5 - top)));
    const int x1 = int(std::min(double(side - 1), std::floor(high.x() - 0.5 - left)));
    const int y1 = int(std::min(double(side - 1), std::floor(high.y() - 0.5 - top)));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const Eigen::Vector2d s(left + x + 0.5, top + y + 0.5);
            const double wp = edgeP(s), wq = edgeQ(s), wr = edgeR(s);
            if (!edgeP.isInside(wp) || !edgeQ.isInside(wq) || !edgeR.isInside(wr))
                continue;
            const auto depth = float(area / (wp * zp + wq * zq + wr * zr)); // 1/z is linear on the screen
            Sample &sample = samples[std::size_t(y) * std::size_t(side) + std::size_t(x)];
            if (sample.triangle < 0 || depth < sample.surfaceDepth) {
                sample.surfaceDepth = depth;
                sample.triangle = triangle;
            }
        }
    }
}

void Visibility::traceTube(int tube, int left, int top, std::vector<Sample> &samples) const
{
    const ScreenTube &screen = mTubes[std::size_t(tube)];
    const StageTube &source = mStage.tubes[std::size_t(tube)];
    const int side = tileSamples();
    const int x0 = int(std::clamp(screen.boxMin.x() - left, 0.0, double(side)));
    const int y0 = int(std::clamp(screen.boxMin.y() - top, 0.0, double(side)));
    const int x1 = int(std::clamp(screen.boxMax.x() - left, -1.0, double(side - 1)));
    const int y1 = int(std::clamp(screen.boxMax.y() - top, -1.0, double(side - 1)));
    // Long slanted pieces fill little of their box: skip what is far from the line.
    const Eigen::Vector2d a = mCamera.project(screen.ends[0]);
    const Eigen::Vector2d b = mCamera.project(screen.ends[1]);
    const double length = (b - a).norm();
    const Eigen::Vector2d normal = length > 1e-9
                                       ? Eigen::Vector2d((a.y() - b.y()) / length, (b.x() - a.x()) / length)
                                       : Eigen::Vector2d(0.0, 0.0);
    const double reach = std::max((screen.boxMax - a.cwiseMax(b)).maxCoeff(), 1.0);
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const Eigen::Vector2d s(left + x + 0.5, top + y + 0.5);
            if (std::abs(normal.dot(s - a)) > reach)
                continue;
            TubeHit hit;
            if (!hitTube(screen.ends[0], screen.ends[1], screen.radius, mCamera.ray(s.x(), s.y()), hit))
                continue;
            Sample &sample = samples[std::size_t(y) * std::size_t(side) + std::size_t(x)];
            const bool visible =
                sample.triangle < 0 || hit.depth - screen.visibleBehind <= double(sample.surfaceDepth);
            if (visible && (sample.tube < 0 || hit.depth < double(sample.tubeDepth))) {
                sample.tube = tube;
                sample.tubeDepth = float(hit.depth);
            } else if (!visible && source.faintWhenHidden && sample.hiddenTube < 0) {
                sample.hiddenTube = tube; // faint ones are flat, so any of them will do
            }
        }
    }
}

Vec3 Visibility::barycentric(int triangle, double sampleX, double sampleY) const
{
    const ScreenTriangle &screen = mTriangles[std::size_t(triangle)];
    const Eigen::Vector2d s(sampleX, sampleY);
    Vec3 weights;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector2d &q = screen.points[(k + 1) % 3];
        const Eigen::Vector2d &r = screen.points[(k + 2) % 3];
        weights[k] = cross(r - q, s - q) / screen.area * screen.inverseDepth[k];
    }
    return weights / weights.sum();
}

} // namespace ductus::picture
