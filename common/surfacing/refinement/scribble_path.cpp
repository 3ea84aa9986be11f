#include "surfacing/refinement/scribble_path.h"

#include "geometry/dual_path.h"

#include <algorithm>
#include <set>

namespace ductus {

namespace {

// Further away nobody meant this surface. Share of the box diagonal.
constexpr double farthestPoint = 0.25;
// How much further from the surface than its ends a leg may lie to be followed point by point.
constexpr double straightLegDistance = 0.03;

int nearestCorner(const TriangleMesh &mesh, const NearestPoint &foot)
{
    int corner = 0;
    foot.barycentric.maxCoeff(&corner);
    return mesh.triangles[std::size_t(foot.triangle)][std::size_t(corner)];
}

double distanceToSegment(const Vec3 &p, const Vec3 &a, const Vec3 &b)
{
    const Vec3 d = b - a;
    const double squared = d.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - a).dot(d) / squared, 0.0, 1.0) : 0.0;
    return (a + t * d - p).norm();
}

class Walker
{
public:
    Walker(const TriangleMesh &mesh, const MeshTopology &topology) : mMesh(mesh), mTopology(topology) {}

    void visit(int vertex)
    {
        if (mSeen.insert(vertex).second)
            mPath.vertices.push_back(vertex);
    }

    void startIn(int triangle) { mPath.triangles.push_back(triangle); }

    void cross(int edge)
    {
        const int from = mPath.triangles.back();
        const auto [left, right] = sidesOfCrossing(mMesh, mTopology, edge, from);
        mPath.crossedEdges.push_back(edge);
        mPath.left.push_back(left);
        mPath.right.push_back(right);
        mPath.triangles.push_back(mTopology.across(edge, from));
    }

    ScribblePath take() { return std::move(mPath); }

private:
    const TriangleMesh &mMesh;
    const MeshTopology &mTopology;
    ScribblePath mPath;
    std::set<int> mSeen;
};

} // namespace

std::pair<int, int> sidesOfCrossing(const TriangleMesh &mesh, const MeshTopology &topology, int edge,
                                    int from)
{
    // The triangle walked out of runs its edge a -> b with itself on the left, so b is left of the walker.
    const MeshEdge &e = topology.edges[std::size_t(edge)];
    const Triangle &corners = mesh.triangles[std::size_t(from)];
    for (std::size_t k = 0; k < 3; ++k)
        if (corners[k] == e.v0 && corners[(k + 1) % 3] == e.v1)
            return {e.v1, e.v0};
    return {e.v0, e.v1};
}

Result<ScribblePath> layOnProxy(const ScribbleDomain &domain, const std::vector<Vec3> &points)
{
    const TriangleMesh &mesh = domain.proxy;
    std::vector<NearestPoint> feet;
    const double step = 1.5 * meanEdgeLength(mesh);
    std::optional<Vec3> previous;
    for (const Vec3 &point : points) {
        Vec3 p = domain.frame.unitFromInput(point);
        if (domain.plane && domain.plane->signedDistance(p) < 0.0)
            p = domain.plane->mirrored(p);
        const NearestPoint foot = domain.nearest.nearest(p);
        if (foot.distance > farthestPoint)
            continue;
        // Shortest paths over triangles stray by a tenth of their length; points in between keep long legs
        // straight, where the leg stays near the surface.
        if (previous) {
            const double near = std::max(feet.back().distance, foot.distance) + straightLegDistance;
            const int count = int((p - *previous).norm() / step);
            for (int i = 1; i < count; ++i) {
                const NearestPoint between =
                    domain.nearest.nearest(*previous + (p - *previous) * i / double(count));
                if (between.distance <= near)
                    feet.push_back(between);
            }
        }
        feet.push_back(foot);
        previous = p;
    }
    if (feet.empty())
        return Error{ErrorCode::InvalidArgument, "Applying a scribble",
                     points.empty() ? "it has no points" : "it lies far from the surface",
                     "Give points on the surface, in the coordinates of the sketch", ""};

    DualPaths paths(mesh, domain.topology);
    Walker walker(mesh, domain.topology);
    walker.startIn(feet.front().triangle);
    walker.visit(nearestCorner(mesh, feet.front()));
    for (std::size_t i = 1; i < feet.size(); ++i) {
        const NearestPoint &from = feet[i - 1], &to = feet[i];
        // The way over the surface may be long where the line takes a short cut through the inside.
        const double reach = 4.0 * (to.point - from.point).norm() + 8.0 * meanEdgeLength(mesh);
        bool found = false;
        const std::vector<int> crossed = paths.crossedEdges(from.triangle, to.triangle, reach, &found);
        if (!found)
            walker.startIn(to.triangle); // another piece of the surface: the line goes on there
        for (int edge : crossed) {
            walker.cross(edge);
            const MeshEdge &e = domain.topology.edges[std::size_t(edge)];
            const Vec3 &a = mesh.vertices[std::size_t(e.v0)], &b = mesh.vertices[std::size_t(e.v1)];
            walker.visit(distanceToSegment(a, from.point, to.point) <=
                                 distanceToSegment(b, from.point, to.point)
                             ? e.v0
                             : e.v1);
        }
        walker.visit(nearestCorner(mesh, to));
    }
    return walker.take();
}

} // namespace ductus
