#include "surfacing/refinement/region_cut.h"

#include "numeric/alpha_expansion.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace ductus {

namespace {

// A line whose ends are nearer than this share of its length was meant to close up.
constexpr double closingShare = 0.25;
// Along strokes the way to the border is that much shorter.
constexpr double strokeDiscount = 0.2;

class Cutter
{
public:
    Cutter(const ScribbleDomain &domain, const std::vector<int> &part, const ScribblePath &path)
        : mDomain(domain), mTopology(domain.topology), mPart(part), mPath(path),
          mInPart(domain.proxy.vertices.size(), 0), mIsCrossed(domain.topology.edges.size(), 0),
          mVotes(domain.proxy.vertices.size(), 0)
    {
        for (int v : part)
            mInPart[std::size_t(v)] = 1;
        for (std::size_t i = 0; i < path.crossedEdges.size(); ++i)
            cross(path.crossedEdges[i], path.left[i], path.right[i]);
        leaveSurface(path.triangles.front(), true);
        leaveSurface(path.triangles.back(), false);
    }

    void extend()
    {
        if (nearlyCloses())
            return goOn(mPath.triangles.back(), mPath.triangles.front(), false);
        goOn(mPath.triangles.back(), -1, false);
        goOn(mPath.triangles.front(), -1, true);
    }

    // Connected components without the crossed edges, each on the side most of its vertices next to the line
    // are.
    std::optional<RegionCut> cut() const
    {
        RegionCut result;
        std::vector<char> seen(mInPart.size(), 0);
        for (int start : mPart) {
            if (seen[std::size_t(start)])
                continue;
            std::vector<int> component{start};
            seen[std::size_t(start)] = 1;
            int votes = 0;
            for (std::size_t next = 0; next < component.size(); ++next) {
                const int v = component[next];
                votes += mVotes[std::size_t(v)];
                for (int e : mTopology.vertexEdges[std::size_t(v)]) {
                    const int w = mTopology.neighbour(v, e);
                    if (mInPart[std::size_t(w)] && !seen[std::size_t(w)] && !mIsCrossed[std::size_t(e)]) {
                        seen[std::size_t(w)] = 1;
                        component.push_back(w);
                    }
                }
            }
            std::vector<int> &side = votes > 0 ? result.left : result.right;
            side.insert(side.end(), component.begin(), component.end());
        }
        if (result.left.empty() || result.right.empty())
            return std::nullopt;
        std::sort(result.left.begin(), result.left.end());
        std::sort(result.right.begin(), result.right.end());
        std::vector<char> isLeft(mInPart.size(), 0);
        for (int v : result.left)
            isLeft[std::size_t(v)] = 1;
        for (std::size_t e = 0; e < mIsCrossed.size(); ++e) {
            if (!mIsCrossed[e])
                continue;
            result.crossedEdges.push_back(int(e));
            for (int v : {mTopology.edges[e].v0, mTopology.edges[e].v1})
                (isLeft[std::size_t(v)] ? result.seamLeft : result.seamRight).push_back(v);
        }
        for (std::vector<int> *side : {&result.seamLeft, &result.seamRight}) {
            std::sort(side->begin(), side->end());
            side->erase(std::unique(side->begin(), side->end()), side->end());
        }
        return result;
    }

private:
    void cross(int edge, int left, int right)
    {
        if (!mInPart[std::size_t(left)] || !mInPart[std::size_t(right)])
            return;
        mIsCrossed[std::size_t(edge)] = 1;
        ++mVotes[std::size_t(left)];
        --mVotes[std::size_t(right)];
    }

    // A line that ends in a triangle on the border of an open surface goes out there: the border edge would
    // else join its two sides.
    void leaveSurface(int triangle, bool backwards)
    {
        for (int e : mTopology.faceEdges[std::size_t(triangle)]) {
            if (!mTopology.isBorder(e))
                continue;
            auto [left, right] = sidesOfCrossing(mDomain.proxy, mTopology, e, triangle);
            if (backwards)
                std::swap(left, right);
            cross(e, left, right);
            return;
        }
    }

    bool nearlyCloses() const
    {
        double length = 0.0;
        for (std::size_t i = 1; i < mPath.triangles.size(); ++i)
            length +=
                (mDomain.proxy.centroid(mPath.triangles[i]) - mDomain.proxy.centroid(mPath.triangles[i - 1]))
                    .norm();
        const double gap =
            (mDomain.proxy.centroid(mPath.triangles.back()) - mDomain.proxy.centroid(mPath.triangles.front()))
                .norm();
        return mPath.triangles.size() > 8 && gap < closingShare * length;
    }

    bool leavesPart(int triangle) const
    {
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = mDomain.proxy.triangles[std::size_t(triangle)][k];
            const int e = mTopology.faceEdges[std::size_t(triangle)][k];
            if (!mInPart[std::size_t(v)] || mTopology.edges[std::size_t(e)].faceCount != 2)
                return true;
        }
        return false;
    }

    // The shortest way from the end of the line to triangle \a goal, or (-1) to the nearest border of the
    // part, without touching the line; \a backwards at its beginning, where left and right change places.
    void goOn(int from, int goal, bool backwards)
    {
        const TriangleMesh &mesh = mDomain.proxy;
        if (goal < 0 && leavesPart(from))
            return;
        std::vector<char> isWalked(mesh.triangles.size(), 0);
        for (int t : mPath.triangles)
            isWalked[std::size_t(t)] = t != goal;
        std::vector<double> distance(mesh.triangles.size(), HUGE_VAL);
        std::vector<int> viaEdge(mesh.triangles.size(), -1);
        using Entry = std::pair<double, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        distance[std::size_t(from)] = 0.0;
        open.push({0.0, from});
        int reached = -1;
        while (!open.empty() && reached < 0) {
            const auto [d, t] = open.top();
            open.pop();
            if (d > distance[std::size_t(t)])
                continue;
            if (goal < 0 ? leavesPart(t) : t == goal) {
                reached = t;
                break;
            }
            for (int e : mTopology.faceEdges[std::size_t(t)]) {
                const int next = mTopology.across(e, t);
                if (next < 0 || isWalked[std::size_t(next)] || mTopology.edges[std::size_t(e)].faceCount != 2)
                    continue;
                const double step =
                    (mesh.centroid(next) - mesh.centroid(t)).norm() *
                    (mDomain.association.edgeIsCrossed[std::size_t(e)] ? strokeDiscount : 1.0);
                if (d + step < distance[std::size_t(next)]) {
                    distance[std::size_t(next)] = d + step;
                    viaEdge[std::size_t(next)] = e;
                    open.push({d + step, next});
                }
            }
        }
        if (reached >= 0 && goal < 0)
            leaveSurface(reached, backwards);
        for (int t = reached; t >= 0 && t != from;) {
            const int e = viaEdge[std::size_t(t)];
            const int previous = mTopology.across(e, t);
            auto [left, right] = sidesOfCrossing(mesh, mTopology, e, previous);
            if (backwards)
                std::swap(left, right);
            cross(e, left, right);
            t = previous;
        }
    }

    const ScribbleDomain &mDomain;
    const MeshTopology &mTopology;
    const std::vector<int> &mPart;
    const ScribblePath &mPath;
    std::vector<char> mInPart;
    std::vector<char> mIsCrossed; // one an edge
    std::vector<int> mVotes;      // one a vertex: how often left of the line less how often right
};

} // namespace

std::optional<RegionCut> cutAlong(const ScribbleDomain &domain, const std::vector<int> &part,
                                  const ScribblePath &path, CutEnds ends)
{
    Cutter cutter(domain, part, path);
    if (ends == CutEnds::Extended)
        cutter.extend();
    return cutter.cut();
}

void snapToStrokes(const ScribbleDomain &domain, RegionCut &cut, double reach)
{
    // More than the whole border, so that nothing beyond the reach changes sides.
    double seedCost = 1.0;
    for (double w : domain.association.edgeWeights)
        seedCost += w;
    const MeshTopology &topology = domain.topology;
    const std::size_t vertexCount = domain.proxy.vertices.size();
    std::vector<int> indexOf(vertexCount, -1), vertices;
    for (const std::vector<int> *side : {&cut.left, &cut.right})
        for (int v : *side) {
            indexOf[std::size_t(v)] = int(vertices.size());
            vertices.push_back(v);
        }
    // Distance from the line along edges of the region.
    std::vector<double> distance(vertexCount, HUGE_VAL);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const std::vector<int> *seam : {&cut.seamLeft, &cut.seamRight})
        for (int v : *seam) {
            distance[std::size_t(v)] = 0.0;
            open.push({0.0, v});
        }
    while (!open.empty()) {
        const auto [d, v] = open.top();
        open.pop();
        if (d > distance[std::size_t(v)] || d > reach)
            continue;
        for (int e : topology.vertexEdges[std::size_t(v)]) {
            const int w = topology.neighbour(v, e);
            const double through =
                d + (domain.proxy.vertices[std::size_t(w)] - domain.proxy.vertices[std::size_t(v)]).norm();
            if (indexOf[std::size_t(w)] >= 0 && through < distance[std::size_t(w)]) {
                distance[std::size_t(w)] = through;
                open.push({through, w});
            }
        }
    }
    std::vector<double> toLeft(vertices.size(), 0.0), toRight(vertices.size(), 0.0);
    bool hasLeftSeed = false, hasRightSeed = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (distance[std::size_t(vertices[i])] <= reach)
            continue;
        const bool isLeft = i < cut.left.size();
        (isLeft ? toRight : toLeft)[i] = seedCost;
        (isLeft ? hasLeftSeed : hasRightSeed) = true;
    }
    if (!hasLeftSeed || !hasRightSeed)
        return; // the parts are too small to have room for another line
    LabelingProblem problem;
    problem.vertexCount = int(vertices.size());
    problem.dataCosts = {toLeft, toRight};
    problem.labelCosts = {0.0, 0.0};
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const int a = indexOf[std::size_t(topology.edges[e].v0)],
                  b = indexOf[std::size_t(topology.edges[e].v1)];
        if (a >= 0 && b >= 0)
            problem.edges.push_back({a, b, domain.association.edgeWeights[e]});
    }
    std::vector<int> start(vertices.size(), 0);
    for (std::size_t i = cut.left.size(); i < start.size(); ++i)
        start[i] = 1;
    const Result<Labeling> labeling = alphaExpansion(problem, {}, start, JobControl());
    if (!labeling)
        return; // the line as drawn stands
    // Without a stroke to go to, the shortest border cuts corners off what was drawn.
    int atStrokes = 0, elsewhere = 0;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const int a = indexOf[std::size_t(topology.edges[e].v0)],
                  b = indexOf[std::size_t(topology.edges[e].v1)];
        if (a >= 0 && b >= 0 && labeling->labels[std::size_t(a)] != labeling->labels[std::size_t(b)])
            ++(domain.association.edgeIsCrossed[e] ? atStrokes : elsewhere);
    }
    if (atStrokes < 2 * elsewhere)
        return;
    cut.left.clear();
    cut.right.clear();
    for (std::size_t i = 0; i < vertices.size(); ++i)
        (labeling->labels[i] == 0 ? cut.left : cut.right).push_back(vertices[i]);
    std::sort(cut.left.begin(), cut.left.end());
    std::sort(cut.right.begin(), cut.right.end());
}

} // namespace ductus
