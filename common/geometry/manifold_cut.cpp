#include "geometry/manifold_cut.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace ductus {

namespace {

int next(int h)
{
    return h % 3 == 2 ? h - 2 : h + 1;
}

int root(std::vector<int> &parent, int i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

class Cutter
{
public:
    explicit Cutter(const TriangleMesh &mesh)
        : mMesh(mesh), mMate(3 * mesh.triangles.size(), -1), mFromCrowd(3 * mesh.triangles.size(), 0),
          mFlipped(mesh.triangles.size(), 0)
    {
    }

    /// True if the result is clean; else some edges were given a middle vertex and another round is due.
    bool run(ManifoldCut &result);

private:
    int from(int h) const { return mMesh.triangles[h / 3][h % 3]; }
    int to(int h) const { return from(next(h)); }
    int apex(int h) const { return from(next(next(h))); }

    std::vector<std::vector<int>> halfEdgesByEdge() const;
    void pair();
    void pairCrowd(const std::vector<int> &crowd);
    void join(int h, int g);
    std::vector<int> orient();
    void turnComponents(const std::vector<int> &component);
    void splitVertices(ManifoldCut &result);
    bool splitDoubleEdges(ManifoldCut &result);

    TriangleMesh mMesh;
    std::vector<int> mMate;       // the half-edge each one stays joined with, -1 for none
    std::vector<char> mFromCrowd; // the joint is one of several at its edge
    std::vector<char> mFlipped;
};

/// Half-edges 3 t + k grouped by the edge they lie on, each group ascending.
std::vector<std::vector<int>> Cutter::halfEdgesByEdge() const
{
    std::vector<std::tuple<int, int, int>> sides;
    sides.reserve(mMate.size());
    for (int h = 0; h < int(mMate.size()); ++h)
        sides.push_back({std::min(from(h), to(h)), std::max(from(h), to(h)), h});
    std::sort(sides.begin(), sides.end());
    std::vector<std::vector<int>> groups;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto &[a, b, h] = sides[i];
        if (i == 0 || std::get<0>(sides[i - 1]) != a || std::get<1>(sides[i - 1]) != b)
            groups.emplace_back();
        groups.back().push_back(h);
    }
    return groups;
}

void Cutter::join(int h, int g)
{
    mMate[h] = g;
    mMate[g] = h;
}

void Cutter::pair()
{
    for (const std::vector<int> &group : halfEdgesByEdge()) {
        if (group.size() == 2)
            join(group[0], group[1]);
        else if (group.size() > 2)
            pairCrowd(group);
    }
}

void Cutter::pairCrowd(const std::vector<int> &crowd)
{
    // Angle of each triangle around the edge, seen along it from its lower to its higher vertex.
    const int low = std::min(from(crowd[0]), to(crowd[0]));
    const int high = std::max(from(crowd[0]), to(crowd[0]));
    const Vec3 axis = (mMesh.vertices[high] - mMesh.vertices[low]).normalized();
    const auto arm = [&](int h) {
        const Vec3 v = mMesh.vertices[apex(h)] - mMesh.vertices[low];
        return Vec3(v - axis * axis.dot(v));
    };
    const Vec3 x = arm(crowd[0]).normalized();
    const Vec3 y = axis.cross(x);
    std::vector<std::pair<double, int>> around;
    for (int h : crowd)
        around.push_back({std::atan2(arm(h).dot(y), arm(h).dot(x)), h});
    std::sort(around.begin(), around.end());

    const int n = int(around.size());
    const auto isUp = [&](int i) { return from(around[(i + n) % n].second) == low; };
    bool alternating = n % 2 == 0;
    for (int i = 0; i < n; ++i)
        alternating = alternating && isUp(i) != isUp(i + 1);
    for (int h : crowd)
        mFromCrowd[h] = 1;
    if (alternating) {
        // Solids that touch: the outside of a triangle that runs up is counter-clockwise of it, so its solid
        // reaches clockwise to the triangle before.
        for (int i = 0; i < n; ++i)
            if (isUp(i))
                join(around[i].second, around[(i + n - 1) % n].second);
        return;
    }

    // Sheets: the pairs nearest to a straight continuation first, those that agree in direction before the
    // rest.
    using Candidate = std::tuple<bool, double, int, int>;
    std::vector<Candidate> candidates;
    for (int i = 0; i < n; ++i) {
        for (int j = i + 1; j < n; ++j) {
            const double bend = std::abs(std::numbers::pi - (around[j].first - around[i].first));
            candidates.push_back({isUp(i) == isUp(j), bend, around[i].second, around[j].second});
        }
    }
    std::sort(candidates.begin(), candidates.end());
    for (const auto &[disagree, bend, h, g] : candidates)
        if (mMate[h] < 0 && mMate[g] < 0)
            join(h, g);
}

/// Decides mFlipped so that joined triangles agree, and undoes joints where they cannot. Component of each
/// triangle.
std::vector<int> Cutter::orient()
{
    std::vector<int> component(mMesh.triangles.size(), -1);
    int count = 0;
    for (int seed = 0; seed < mMesh.triangleCount(); ++seed) {
        if (component[seed] >= 0)
            continue;
        // Plain joints first: if there is a conflict it shows, and is cut, where more than two triangles
        // meet.
        std::deque<int> plain, crowded;
        const auto reach = [&](int t) {
            component[t] = count;
            for (int h = 3 * t; h < 3 * t + 3; ++h)
                if (mMate[h] >= 0)
                    (mFromCrowd[h] ? crowded : plain).push_back(h);
        };
        reach(seed);
        while (!plain.empty() || !crowded.empty()) {
            std::deque<int> &queue = plain.empty() ? crowded : plain;
            const int h = queue.front();
            queue.pop_front();
            const int g = mMate[h];
            if (g < 0)
                continue;
            const char wanted = mFlipped[h / 3] ^ (from(h) == from(g) ? 1 : 0);
            if (component[g / 3] < 0) {
                mFlipped[g / 3] = wanted;
                reach(g / 3);
            } else if (mFlipped[g / 3] != wanted) {
                mMate[h] = mMate[g] = -1;
            }
        }
        ++count;
    }
    return component;
}

void Cutter::turnComponents(const std::vector<int> &component)
{
    const int count = component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
    std::vector<double> volume(count, 0.0);
    std::vector<int> closed(count, 1), balance(count, 0), first(count, -1);
    for (int t = 0; t < mMesh.triangleCount(); ++t) {
        const int c = component[t];
        if (first[c] < 0)
            first[c] = mMesh.triangles[t][0];
        const Vec3 &origin = mMesh.vertices[first[c]]; // near, so that little cancels
        const Vec3 p = mMesh.vertices[mMesh.triangles[t][0]] - origin;
        const Vec3 q = mMesh.vertices[mMesh.triangles[t][1]] - origin;
        const Vec3 r = mMesh.vertices[mMesh.triangles[t][2]] - origin;
        volume[c] += (mFlipped[t] ? -1.0 : 1.0) * p.dot(q.cross(r));
        balance[c] += mFlipped[t] ? 1 : -1;
        for (int h = 3 * t; h < 3 * t + 3; ++h)
            closed[c] = closed[c] && mMate[h] >= 0;
    }
    for (int t = 0; t < mMesh.triangleCount(); ++t) {
        const int c = component[t];
        if (closed[c] && volume[c] != 0.0 ? volume[c] < 0.0 : balance[c] > 0)
            mFlipped[t] ^= 1;
    }
}

void Cutter::splitVertices(ManifoldCut &result)
{
    std::vector<int> parent(mMate.size()); // one entry a corner: the start of the half-edge of that number
    std::iota(parent.begin(), parent.end(), 0);
    for (int h = 0; h < int(mMate.size()); ++h) {
        const int g = mMate[h];
        if (g < h)
            continue;
        const bool same = from(h) == from(g);
        parent[root(parent, h)] = root(parent, same ? g : next(g));
        parent[root(parent, next(h))] = root(parent, same ? next(g) : g);
    }
    std::vector<char> taken(mMesh.vertices.size(), 0);
    std::vector<int> vertexOfRoot(mMate.size(), -1);
    result.mesh.vertices = mMesh.vertices;
    result.mesh.triangles.assign(mMesh.triangles.size(), Triangle{});
    for (int h = 0; h < int(mMate.size()); ++h) {
        int &vertex = vertexOfRoot[root(parent, h)];
        if (vertex < 0 && !taken[from(h)]) {
            vertex = from(h);
            taken[vertex] = 1;
        } else if (vertex < 0) {
            vertex = result.mesh.vertexCount();
            result.mesh.vertices.push_back(Vec3(mMesh.vertices[from(h)]));
            ++result.splitVertices;
        }
        result.mesh.triangles[h / 3][h % 3] = vertex;
    }
}

/// An edge may still carry several joints, where the fans at both ends hang together elsewhere. All but the
/// first get a vertex in the middle. False if there were any.
bool Cutter::splitDoubleEdges(ManifoldCut &result)
{
    Cutter after(result.mesh); // for its edges; half-edges have the numbers they have here
    std::vector<char> busy(mMesh.triangles.size(), 0);
    bool clean = true;
    for (const std::vector<int> &group : after.halfEdgesByEdge()) {
        const auto direction = [&](int h) { return (after.from(h) < after.to(h)) != bool(mFlipped[h / 3]); };
        if (group.size() == 1 || (group.size() == 2 && direction(group[0]) != direction(group[1])))
            continue;
        clean = false;
        const int kept = group[0];
        for (int h : group) {
            const int g = mMate[h];
            if (h == kept || g == kept || (g >= 0 && g < h))
                continue;
            if (busy[h / 3] || (g >= 0 && busy[g / 3]))
                continue; // in the next round
            const int middle = result.mesh.vertexCount();
            const Vec3 position =
                0.5 * (result.mesh.vertices[after.from(h)] + result.mesh.vertices[after.to(h)]);
            result.mesh.vertices.push_back(position);
            for (int side : {h, g}) {
                if (side < 0)
                    continue;
                busy[side / 3] = 1;
                Triangle second = result.mesh.triangles[side / 3];
                second[side % 3] = middle;
                result.mesh.triangles[side / 3][next(side) % 3] = middle;
                result.mesh.triangles.push_back(second);
                mFlipped.push_back(char(mFlipped[side / 3]));
            }
        }
    }
    return clean;
}

bool Cutter::run(ManifoldCut &result)
{
    pair();
    turnComponents(orient());
    splitVertices(result);
    const bool clean = splitDoubleEdges(result);
    for (int t = 0; t < result.mesh.triangleCount(); ++t) {
        if (!mFlipped[t])
            continue;
        std::swap(result.mesh.triangles[t][1], result.mesh.triangles[t][2]);
        ++result.reorientedTriangles;
    }
    return clean;
}

} // namespace

ManifoldCut cutToManifold(const TriangleMesh &mesh)
{
    ManifoldCut result;
    result.mesh = mesh;
    bool clean = false;
    // Each round makes at least one joint free of its double; few meshes need a second one.
    while (!clean) {
        Cutter cutter(result.mesh);
        clean = cutter.run(result);
    }
    return result;
}

} // namespace ductus
