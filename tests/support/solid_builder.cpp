#include "support/solid_builder.h"

#include "base/assert.h"
#include "geometry/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ductus {

namespace {

/// Gives points closer than the tolerance the same number.
class Welder
{
public:
    int indexOf(const Vec3 &point)
    {
        if (const int found = find(point); found >= 0)
            return found;
        mCells[cellOf(point)].push_back(int(mPoints.size()));
        mPoints.push_back(point);
        return int(mPoints.size()) - 1;
    }

    int find(const Vec3 &point) const
    {
        const Cell centre = cellOf(point);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                for (std::int64_t dz = -1; dz <= 1; ++dz) {
                    const auto it = mCells.find({centre[0] + dx, centre[1] + dy, centre[2] + dz});
                    if (it == mCells.end())
                        continue;
                    for (const int i : it->second)
                        if ((mPoints[i] - point).norm() < tolerance)
                            return i;
                }
        return -1;
    }

    const std::vector<Vec3> &points() const { return mPoints; }

private:
    using Cell = std::array<std::int64_t, 3>;
    static constexpr double tolerance = 1e-7;

    static Cell cellOf(const Vec3 &point)
    {
        Cell cell;
        for (int k = 0; k < 3; ++k)
            cell[k] = std::int64_t(std::floor(point[k] / (4.0 * tolerance)));
        return cell;
    }

    std::map<Cell, std::vector<int>> mCells;
    std::vector<Vec3> mPoints;
};

bool runsAlong(const Triangle &triangle, int a, int b)
{
    for (int k = 0; k < 3; ++k)
        if (triangle[k] == a && triangle[(k + 1) % 3] == b)
            return true;
    return false;
}

/// Flips triangles until neighbours agree with the first triangle of their component.
void orientConsistently(TriangleMesh &mesh, const MeshTopology &topology)
{
    std::vector<char> done(mesh.triangles.size(), 0);
    for (int seed = 0; seed < mesh.triangleCount(); ++seed) {
        if (done[seed])
            continue;
        std::vector<int> stack{seed};
        done[seed] = 1;
        while (!stack.empty()) {
            const int face = stack.back();
            stack.pop_back();
            for (const int e : topology.faceEdges[face]) {
                const MeshEdge &edge = topology.edges[e];
                DUCTUS_ASSERT(edge.faceCount <= 2);
                const int other = topology.across(e, face);
                if (other < 0 || done[other])
                    continue;
                if (runsAlong(mesh.triangles[face], edge.v0, edge.v1) ==
                    runsAlong(mesh.triangles[other], edge.v0, edge.v1))
                    std::swap(mesh.triangles[other][1], mesh.triangles[other][2]);
                done[other] = 1;
                stack.push_back(other);
            }
        }
    }
}

/// A point is sharp if the mesh edge before or after it on the curve is.
std::vector<char> sharpPoints(const Polyline &points, const Welder &welder, const TriangleMesh &mesh,
                              const MeshTopology &topology)
{
    std::vector<char> sharp(points.size(), 0);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const int a = welder.find(points[i]), b = welder.find(points[i + 1]);
        if (a < 0 || b < 0 || a == b)
            continue;
        const int edge = topology.edgeBetween(a, b);
        if (edge >= 0 && dihedralDegrees(mesh, topology, edge) > Solid::sharpDegrees)
            sharp[i] = sharp[i + 1] = 1;
    }
    return sharp;
}

} // namespace

double dihedralDegrees(const TriangleMesh &mesh, const MeshTopology &topology, int edge)
{
    const MeshEdge &e = topology.edges[edge];
    if (e.faceCount != 2)
        return 0.0;
    const Vec3 a = mesh.faceNormal(e.faces[0]), b = mesh.faceNormal(e.faces[1]);
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

int SolidBuilder::addFace(std::string name)
{
    mFaces.push_back(std::move(name));
    return int(mFaces.size()) - 1;
}

void SolidBuilder::addGrid(int face, const GridPatch &grid)
{
    for (int r = 0; r + 1 < grid.rows; ++r)
        for (int c = 0; c + 1 < grid.columns; ++c)
            mCells.push_back(
                {face, {grid.at(r, c), grid.at(r, c + 1), grid.at(r + 1, c + 1), grid.at(r + 1, c)}});
}

void SolidBuilder::addCurve(std::string name, CurveKind kind, Polyline points)
{
    mCurves.push_back({std::move(name), kind, std::move(points), {}});
}

Solid SolidBuilder::finish(std::optional<MirrorPlane> mirror) const
{
    Solid solid;
    solid.id = mId;
    solid.faceNames = mFaces;
    solid.mirror = mirror;
    Welder welder;
    for (const Cell &cell : mCells) {
        std::array<int, 4> v;
        for (int k = 0; k < 4; ++k)
            v[k] = welder.indexOf(cell.corners[k] * mScale);
        // The shorter diagonal; which of two equal ones must not depend on rounding.
        const double ac = (cell.corners[0] - cell.corners[2]).norm(),
                     bd = (cell.corners[1] - cell.corners[3]).norm();
        const std::array<Triangle, 2> halves =
            ac <= bd * (1.0 + 1e-9)
                ? std::array<Triangle, 2>{Triangle{v[0], v[1], v[2]}, Triangle{v[0], v[2], v[3]}}
                : std::array<Triangle, 2>{Triangle{v[0], v[1], v[3]}, Triangle{v[1], v[2], v[3]}};
        for (const Triangle &t : halves) {
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
                continue;
            solid.mesh.triangles.push_back(t);
            solid.triangleFaces.push_back(cell.face);
        }
    }
    solid.mesh.vertices = welder.points();
    const MeshTopology topology(solid.mesh);
    orientConsistently(solid.mesh, topology);
    for (std::size_t e = 0; e < topology.edges.size(); ++e)
        solid.isOpen = solid.isOpen || topology.isBorder(int(e));
    if (!solid.isOpen && signedVolume(solid.mesh) < 0.0)
        for (Triangle &t : solid.mesh.triangles)
            std::swap(t[1], t[2]);
    solid.curves = mCurves;
    for (FeatureCurve &curve : solid.curves) {
        for (Vec3 &point : curve.points)
            point *= mScale;
        curve.sharp = sharpPoints(curve.points, welder, solid.mesh, topology);
    }
    return solid;
}

} // namespace ductus
