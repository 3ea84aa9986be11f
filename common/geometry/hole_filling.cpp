#include "geometry/hole_filling.h"

#include "geometry/mesh_topology.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <algorithm>
#include <map>
#include <set>

namespace ductus {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

} // namespace

double loopLength(const TriangleMesh &mesh, const std::vector<int> &loop)
{
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        length += (mesh.vertices[std::size_t(loop[i])] - mesh.vertices[std::size_t(loop[(i + 1) % loop.size()])]).norm();
    return length;
}

std::vector<std::vector<int>> borderLoops(const TriangleMesh &mesh)
{
    const MeshTopology topology(mesh);
    // Each border edge as its only triangle runs it; on a manifold every vertex has at most one such successor.
    std::map<int, int> next;
    for (int t = 0; t < mesh.triangleCount(); ++t)
        for (int k = 0; k < 3; ++k)
            if (topology.isBorder(topology.faceEdges[std::size_t(t)][std::size_t(k)]))
                next[mesh.triangles[std::size_t(t)][std::size_t(k)]] =
                    mesh.triangles[std::size_t(t)][std::size_t((k + 1) % 3)];
    std::vector<std::vector<int>> loops;
    std::set<int> visited;
    for (const auto &[start, ignored] : next) {
        if (visited.count(start))
            continue;
        std::vector<int> loop;
        int v = start;
        while (visited.insert(v).second) {
            loop.push_back(v);
            const auto it = next.find(v);
            if (it == next.end())
                break;
            v = it->second;
        }
        if (v == start && loop.size() >= 3)
            loops.push_back(std::move(loop));
    }
    std::stable_sort(loops.begin(), loops.end(), [&](const auto &a, const auto &b) {
        return loopLength(mesh, a) > loopLength(mesh, b);
    });
    return loops;
}

TriangleMesh withHolesFilled(const TriangleMesh &mesh, double maxLength)
{
    TriangleMesh result = mesh;
    std::set<std::pair<int, int>> used; // an edge that exists already must not be made again
    for (const MeshEdge &e : MeshTopology(mesh).edges)
        used.emplace(e.v0, e.v1);
    for (const std::vector<int> &loop : borderLoops(mesh)) {
        if (loopLength(mesh, loop) >= maxLength)
            continue;
        std::vector<Kernel::Point_3> polyline;
        for (int v : loop) {
            const Vec3 &p = mesh.vertices[std::size_t(v)];
            polyline.emplace_back(p.x(), p.y(), p.z());
        }
        std::vector<CGAL::Triple<int, int, int>> patch;
        CGAL::Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(patch));
        const int n = int(loop.size());
        bool clashes = patch.empty();
        std::set<std::pair<int, int>> inner;
        for (const auto &t : patch)
            for (const auto &[i, j] : {std::pair(t.first, t.second), {t.second, t.third}, {t.third, t.first}}) {
                if ((i + 1) % n == j || (j + 1) % n == i)
                    continue;
                const int a = loop[std::size_t(i)], b = loop[std::size_t(j)];
                const std::pair<int, int> edge = std::minmax(a, b);
                clashes |= used.count(edge) > 0;
                inner.insert(edge);
            }
        if (clashes)
            continue;
        used.insert(inner.begin(), inner.end());
        // The patch must run the border edges the other way round than the triangles that are there.
        bool sameWay = false;
        for (const auto &t : patch)
            for (const auto &[i, j] : {std::pair(t.first, t.second), {t.second, t.third}, {t.third, t.first}})
                sameWay |= i == 0 && j == 1;
        for (const auto &t : patch) {
            const int a = loop[std::size_t(t.first)], b = loop[std::size_t(t.second)], c = loop[std::size_t(t.third)];
            result.triangles.push_back(sameWay ? Triangle{a, c, b} : Triangle{a, b, c});
        }
    }
    return result;
}

} // namespace ductus
