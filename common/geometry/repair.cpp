// Repair in four steps: merge equal vertices, drop what is no triangle (handing its middle vertex to the
// neighbour), cut the rest to a manifold, and look for self-intersections.
#include "base/result.h"
#include "geometry/inspection/self_intersection.h"
#include "geometry/manifold_cut.h"
#include "geometry/mesh_topology.h"
#include "geometry/remesh.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace ductus {

namespace {

constexpr const char *attempted = "Repairing the mesh";

// A triangle lower than this share of its longest side counts as having no area; shorter sides are merged.
constexpr double flat = 1e-12;

Result<void> checkInput(const TriangleMesh &mesh)
{
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (!mesh.vertices[v].allFinite() || mesh.vertices[v].cwiseAbs().maxCoeff() > 1e100)
            return Error{ErrorCode::Malformed, attempted,
                         "vertex " + std::to_string(v) + " has a coordinate that is not a usable number",
                         "Export the mesh again", ""};
    for (int t = 0; t < mesh.triangleCount(); ++t)
        for (int v : mesh.triangles[t])
            if (v < 0 || v >= mesh.vertexCount())
                return Error{ErrorCode::Malformed, attempted,
                             "triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                                 " but there are " + std::to_string(mesh.vertexCount()),
                             "Export the mesh again", ""};
    return {};
}

/// Vertices at the same place become the first of them. Number of vertices merged away.
int mergeEqualVertices(TriangleMesh &mesh)
{
    std::vector<int> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    const auto less = [&](int a, int b) {
        const Vec3 &p = mesh.vertices[a];
        const Vec3 &q = mesh.vertices[b];
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    std::stable_sort(order.begin(), order.end(), less);
    std::vector<int> target(mesh.vertices.size());
    int merged = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && !less(order[i - 1], order[i]);
        target[order[i]] = same ? target[order[i - 1]] : order[i];
        merged += same ? 1 : 0;
    }
    for (Triangle &t : mesh.triangles)
        for (int &v : t)
            v = target[v];
    return merged;
}

bool hasRepeatedCorner(const Triangle &t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// The side of \a t that is longest (shortest), starting at that corner.
int extremeSide(const TriangleMesh &mesh, const Triangle &t, bool longest)
{
    const auto length = [&](int k) {
        return (mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).squaredNorm() * (longest ? 1.0 : -1.0);
    };
    int best = 0;
    for (int k = 1; k < 3; ++k)
        if (length(k) > length(best))
            best = k;
    return best;
}

bool isFlat(const TriangleMesh &mesh, const Triangle &t)
{
    const Vec3 &a = mesh.vertices[t[0]];
    const Vec3 &b = mesh.vertices[t[1]];
    const Vec3 &c = mesh.vertices[t[2]];
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !((b - a).cross(c - a).norm() > flat * longest);
}

std::array<int, 3> sortedCorners(Triangle t)
{
    std::sort(t.begin(), t.end());
    return t;
}

/// Keeps the first of triangles with the same corners, none with a corner twice. Number of triangles dropped.
int dropRepeated(TriangleMesh &mesh)
{
    const int before = mesh.triangleCount();
    std::set<std::array<int, 3>> seen;
    std::erase_if(mesh.triangles, [&](const Triangle &t) {
        return hasRepeatedCorner(t) || !seen.insert(sortedCorners(t)).second;
    });
    return before - mesh.triangleCount();
}

/// Takes out triangles without area so that no crack opens: those with a very short side by merging its ends,
/// caps by putting their middle corner into the triangles across their longest side. Number of triangles
/// dropped.
int dropFlat(TriangleMesh &mesh)
{
    int dropped = 0;
    bool changed = true;
    // Splitting may make flat triangles again; after some rounds what is left is just dropped.
    for (int round = 0; changed; ++round) {
        changed = false;
        std::map<std::pair<int, int>, int> middle; // edge -> corner to put into it
        std::vector<int> target(mesh.vertices.size());
        std::iota(target.begin(), target.end(), 0);
        std::vector<Triangle> kept;
        for (const Triangle &t : mesh.triangles) {
            if (!isFlat(mesh, t)) {
                kept.push_back(t);
                continue;
            }
            ++dropped;
            changed = true;
            if (round >= 16)
                continue;
            const int shortSide = extremeSide(mesh, t, false);
            const int longSide = extremeSide(mesh, t, true);
            const int p = t[shortSide], q = t[(shortSide + 1) % 3];
            const int a = t[longSide], b = t[(longSide + 1) % 3], c = t[(longSide + 2) % 3];
            const double shortest = (mesh.vertices[p] - mesh.vertices[q]).norm();
            if (shortest <= 1e3 * flat * (mesh.vertices[a] - mesh.vertices[b]).norm()) {
                if (target[p] == p && target[q] == q)
                    target[std::max(p, q)] = std::min(p, q);
            } else {
                middle.try_emplace({std::min(a, b), std::max(a, b)}, c);
            }
        }
        mesh.triangles.clear();
        for (const Triangle &t : kept) {
            bool split = false;
            for (int k = 0; k < 3 && !split; ++k) {
                const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
                const auto at = middle.find({std::min(a, b), std::max(a, b)});
                if (at == middle.end() || at->second == c)
                    continue;
                mesh.triangles.push_back({a, at->second, c});
                mesh.triangles.push_back({at->second, b, c});
                split = true;
            }
            if (!split)
                mesh.triangles.push_back(t);
        }
        for (Triangle &t : mesh.triangles)
            for (int &v : t)
                while (target[v] != v)
                    v = target[v];
        if (changed)
            dropped += dropRepeated(mesh);
    }
    return dropped;
}

} // namespace

Result<TriangleMesh> repaired(const TriangleMesh &mesh, RepairReport *report)
{
    RepairReport told;
    if (const Result<void> valid = checkInput(mesh); !valid)
        return valid.error();
    const double areaBefore = surfaceArea(mesh);
    TriangleMesh work = mesh;
    told.mergedVertices = mergeEqualVertices(work);
    told.removedTriangles = dropRepeated(work);
    told.removedTriangles += dropFlat(work);
    if (work.isEmpty())
        return Error{ErrorCode::TooLittleData, attempted, "no triangle has an area", "Export the mesh again",
                     ""};
    if (surfaceArea(work) < 0.5 * areaBefore)
        return Error{ErrorCode::NoSolution, attempted,
                     "more than half of the surface consists of repeated or degenerate triangles",
                     "Clean the mesh in the program that made it", ""};
    told.selfIntersecting = !selfIntersections(work, 1).empty(); // before touching sheets get vertices of their own
    ManifoldCut cut = cutToManifold(work);
    told.splitVertices = cut.splitVertices;
    told.reorientedTriangles = cut.reorientedTriangles;
    if (report)
        *report = told;
    return compacted(cut.mesh);
}

} // namespace ductus
