// Incremental isotropic remeshing [Botsch, Kobbelt 2004]: split long edges, collapse short ones, flip towards
// valence 6, smooth along the surface, and put every vertex back onto the input. Every step that would turn a
// triangle over or bend it out of the surface is left out.
#include "geometry/remesh.h"

#include "base/parallel.h"
#include "geometry/editable_mesh.h"
#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "geometry/triangle_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ductus {

namespace {

constexpr const char *attempted = "Remeshing";
constexpr double maxTriangles = 2e7;
constexpr double minTurnCosine = 0.5; // how far a step may turn a triangle
constexpr double minQuality = 0.1;    // of triangles a step makes, unless they were worse before
constexpr double pointTolerance =
    0.1; // of the target length: how far a step may take the surface off a vertex
constexpr double curveTolerance =
    0.02; // of the target length: how far a collapse may move a border or crease

/// 1 for equilateral triangles, 0 for those without area.
double quality(const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return squares > 0.0 ? 2.0 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares : 0.0;
}

class Remesher
{
public:
    Remesher(const TriangleMesh &mesh, const RemeshOptions &options)
        : mMesh(mesh, options.creaseAngleDegrees), mSurface(mesh), mInput(mesh),
          mTarget(options.targetEdgeLength)
    {
    }

    void splitLongEdges();
    void collapseShortEdges();
    void flipForValence();
    void smooth();
    TriangleMesh result() const { return mMesh.toTriangleMesh(); }

private:
    bool keepsShape(const Vec3 &oldArea, double oldQuality, const Vec3 &a, const Vec3 &b,
                    const Vec3 &c) const;
    bool collapseKeepsShape(int h);
    bool flipKeepsShape(int h) const;
    int flipGain(int h);
    int excessValence(int v, int change);
    bool smoothed(int v, std::vector<int> &ring, Vec3 &target) const;
    bool moveKeepsShape(int v, const Vec3 &target);

    EditableMesh mMesh;
    NearestOnMesh mSurface;
    const TriangleMesh &mInput;
    double mTarget;
    std::vector<int> mRing;
};

bool Remesher::keepsShape(const Vec3 &oldArea, double oldQuality, const Vec3 &a, const Vec3 &b,
                          const Vec3 &c) const
{
    const Vec3 area = (b - a).cross(c - a);
    return area.dot(oldArea) >= minTurnCosine * area.norm() * oldArea.norm() &&
           quality(a, b, c) >= std::min(minQuality, oldQuality) && area.squaredNorm() > 0.0;
}

void Remesher::splitLongEdges()
{
    const double limit = 16.0 / 9.0 * mTarget * mTarget; // (4/3 L)^2
    // Longest lengths first, by halves: an edge is never split while one twice as long is left, which keeps
    // the pieces of big triangles well shaped.
    double longest = 0.0;
    for (int h = 0; h < mMesh.halfEdgeCount(); ++h)
        if (mMesh.halfEdgeIsAlive(h))
            longest = std::max(longest, mMesh.squaredLength(h));
    for (double bound = longest; longest > limit; bound = bound / 2.0) {
        bound = std::max(bound, limit);
        for (int h = 0; h < mMesh.halfEdgeCount(); ++h)
            while (mMesh.halfEdgeIsAlive(h) && mMesh.squaredLength(h) > bound)
                mMesh.split(h);
        if (bound == limit)
            break;
    }
}

bool Remesher::collapseKeepsShape(int h)
{
    const int removed = mMesh.from(h);
    const int kept = mMesh.to(h);
    const Vec3 &goal = mMesh.position(kept);
    const double longest = 16.0 / 9.0 * mTarget * mTarget;

    if (mMesh.featureDegree(removed) == 2) { // the curve through removed must stay where it is
        mMesh.outgoing(removed, mRing);
        int other = -1;
        for (int out : mRing) {
            if (mMesh.isFeature(out) && mMesh.to(out) != kept)
                other = mMesh.to(out);
            const int in = EditableMesh::previous(out);
            if (mMesh.isFeature(in) && mMesh.from(in) != kept)
                other = mMesh.from(in);
        }
        if (other < 0)
            return false;
        const Vec3 chord = goal - mMesh.position(other);
        const Vec3 arm = mMesh.position(removed) - mMesh.position(other);
        const double along = chord.dot(arm) / std::max(chord.squaredNorm(), 1e-300);
        if (!(along > 0.0 && along < 1.0) || (arm - along * chord).norm() > curveTolerance * mTarget)
            return false;
    }

    double off = 1e300; // distance of the removed vertex from the triangles that close the gap
    mMesh.outgoing(removed, mRing);
    for (int out : mRing) {
        const int b = mMesh.to(out);
        const int c = mMesh.apex(out);
        if ((b != kept && (mMesh.position(b) - goal).squaredNorm() > longest) ||
            (c != kept && (mMesh.position(c) - goal).squaredNorm() > longest))
            return false;
        if (b == kept || c == kept)
            continue;
        const double oldQuality = quality(mMesh.position(removed), mMesh.position(b), mMesh.position(c));
        if (!keepsShape(mMesh.areaVector(out), oldQuality, goal, mMesh.position(b), mMesh.position(c)))
            return false;
        off = std::min(
            off, distanceToTriangle(mMesh.position(removed), goal, mMesh.position(b), mMesh.position(c)));
    }
    return off <= pointTolerance * mTarget;
}

void Remesher::collapseShortEdges()
{
    const double limit = 16.0 / 25.0 * mTarget * mTarget; // (4/5 L)^2
    // Shortest first; lengths change on the way, so the order is that of the lengths found at the start of a
    // sweep.
    for (int sweep = 0, collapsed = 1; sweep < 20 && collapsed > 0; ++sweep) {
        collapsed = 0;
        std::vector<std::pair<double, int>> shortEdges;
        for (int h = 0; h < mMesh.halfEdgeCount(); ++h)
            if (mMesh.halfEdgeIsAlive(h) && mMesh.squaredLength(h) < limit)
                shortEdges.push_back({mMesh.squaredLength(h), h});
        std::sort(shortEdges.begin(), shortEdges.end());
        for (const auto &[length, h] : shortEdges) {
            // Inner edges come twice, once for either end that may go; border edges once.
            if (!mMesh.halfEdgeIsAlive(h) || !(mMesh.squaredLength(h) < limit))
                continue;
            if (mMesh.canCollapse(h) && collapseKeepsShape(h)) {
                mMesh.collapse(h);
                ++collapsed;
            }
        }
    }
}

int Remesher::excessValence(int v, int change)
{
    mMesh.neighbours(v, mRing);
    const int excess = int(mRing.size()) + change - (mMesh.isBorderVertex(v) ? 4 : 6);
    return excess * excess;
}

int Remesher::flipGain(int h)
{
    const int a = mMesh.from(h);
    const int b = mMesh.to(h);
    const int c = mMesh.apex(h);
    const int d = mMesh.apex(mMesh.opposite(h));
    const int before = excessValence(a, 0) + excessValence(b, 0) + excessValence(c, 0) + excessValence(d, 0);
    return before - excessValence(a, -1) - excessValence(b, -1) - excessValence(c, 1) - excessValence(d, 1);
}

bool Remesher::flipKeepsShape(int h) const
{
    const int g = mMesh.opposite(h);
    const Vec3 &a = mMesh.position(mMesh.from(h));
    const Vec3 &b = mMesh.position(mMesh.to(h));
    const Vec3 &c = mMesh.position(mMesh.apex(h));
    const Vec3 &d = mMesh.position(mMesh.apex(g));
    const double old = std::min(quality(a, b, c), quality(b, a, d));
    const Vec3 areaH = mMesh.areaVector(h);
    const Vec3 areaG = mMesh.areaVector(g);
    if (!keepsShape(areaH, old, d, c, a) || !keepsShape(areaG, old, d, c, a) ||
        !keepsShape(areaH, old, c, d, b) || !keepsShape(areaG, old, c, d, b))
        return false;
    const Vec3 middle = 0.5 * (a + b);
    return std::min(distanceToTriangle(middle, d, c, a), distanceToTriangle(middle, c, d, b)) <=
           pointTolerance * mTarget;
}

void Remesher::flipForValence()
{
    for (int h = 0; h < mMesh.halfEdgeCount(); ++h) {
        if (!mMesh.halfEdgeIsAlive(h) || mMesh.isFeature(h) || h > mMesh.opposite(h))
            continue;
        if (flipGain(h) > 0 && mMesh.canFlip(h) && flipKeepsShape(h))
            mMesh.flip(h);
    }
}

/// Where smoothing sends \a v: the mean of its neighbours, kept at the height of v over the tangent plane
/// and then put onto the input. False if v stays.
bool Remesher::smoothed(int v, std::vector<int> &ring, Vec3 &target) const
{
    if (!mMesh.vertexIsAlive(v) || mMesh.featureDegree(v) != 0)
        return false;
    mMesh.outgoing(v, ring);
    Vec3 mean = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    for (int h : ring) {
        mean += mMesh.position(mMesh.to(h));
        normal += mMesh.areaVector(h);
    }
    mean /= double(ring.size());
    const double length = normal.norm();
    if (!(length > 0.0))
        return false;
    normal /= length;
    const Vec3 &here = mMesh.position(v);
    const NearestPoint foot = mSurface.nearest(mean + normal * normal.dot(here - mean));
    target = foot.point;
    // On thin sheets the nearest point may lie on the other side.
    return mInput.faceNormal(foot.triangle).dot(normal) > minTurnCosine / 2.0;
}

bool Remesher::moveKeepsShape(int v, const Vec3 &target)
{
    double off = 1e300; // distance of the old place from the new triangles
    mMesh.outgoing(v, mRing);
    for (int h : mRing) {
        const Vec3 &b = mMesh.position(mMesh.to(h));
        const Vec3 &c = mMesh.position(mMesh.apex(h));
        if (!keepsShape(mMesh.areaVector(h), quality(mMesh.position(v), b, c), target, b, c))
            return false;
        off = std::min(off, distanceToTriangle(mMesh.position(v), target, b, c));
    }
    return off <= pointTolerance * mTarget;
}

void Remesher::smooth()
{
    const int count = mMesh.vertexCount();
    std::vector<Vec3> targets(count);
    std::vector<char> moves(count, 0);
    parallelChunks(count, 512, [&](std::size_t begin, std::size_t end) {
        std::vector<int> ring;
        for (std::size_t v = begin; v < end; ++v)
            moves[v] = smoothed(int(v), ring, targets[v]) ? 1 : 0;
    });
    for (int v = 0; v < count; ++v)
        if (moves[v] && moveKeepsShape(v, targets[v]))
            mMesh.move(v, targets[v]);
}

Result<void> checkInput(const TriangleMesh &mesh, const RemeshOptions &options)
{
    const auto invalid = [](const char *problem, const char *remedy) {
        return Error{ErrorCode::InvalidArgument, attempted, problem, remedy, ""};
    };
    if (!std::isfinite(options.targetEdgeLength) || !(options.targetEdgeLength > 0.0))
        return invalid("the target edge length must be a positive number", "");
    if (options.iterations < 1 || options.iterations > 1000)
        return invalid("the number of iterations must be in 1 .. 1000", "");
    if (!(options.creaseAngleDegrees >= 0.0 && options.creaseAngleDegrees <= 180.0))
        return invalid("the crease angle must be in 0 .. 180 degrees", "");
    for (const Vec3 &p : mesh.vertices)
        if (!p.allFinite())
            return invalid("a coordinate is not a finite number", "Repair the mesh first");
    for (const Triangle &t : mesh.triangles)
        for (int v : t)
            if (v < 0 || v >= mesh.vertexCount())
                return invalid("a triangle names a vertex that does not exist", "Repair the mesh first");
    const double area = surfaceArea(mesh);
    if (!(area > 0.0))
        return Error{ErrorCode::TooLittleData, attempted, "the mesh has no area", "", ""};
    for (const Triangle &t : mesh.triangles)
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            return invalid("a triangle uses a vertex twice", "Repair the mesh first");
    if (!manifoldReport(mesh).isManifold())
        return invalid("the mesh is not an oriented manifold", "Repair the mesh first");
    if (area / (0.25 * std::sqrt(3.0) * options.targetEdgeLength * options.targetEdgeLength) > maxTriangles)
        return Error{ErrorCode::TooLarge, attempted, "the target edge length asks for too many triangles",
                     "Choose a larger one", ""};
    return {};
}

} // namespace

Result<TriangleMesh> remeshed(const TriangleMesh &mesh, const RemeshOptions &options,
                              const JobControl &control)
{
    if (const Result<void> valid = checkInput(mesh, options); !valid)
        return valid.error();
    Remesher remesher(mesh, options);
    for (int i = 0; i < options.iterations; ++i) {
        control.progress(double(i) / options.iterations, "Evening out the triangles");
        for (const auto step : {&Remesher::splitLongEdges, &Remesher::collapseShortEdges,
                                &Remesher::flipForValence, &Remesher::smooth}) {
            if (control.isCancelled())
                return cancelledError(attempted);
            (remesher.*step)();
        }
    }
    control.progress(1.0, "Evening out the triangles");
    return remesher.result();
}

} // namespace ductus
