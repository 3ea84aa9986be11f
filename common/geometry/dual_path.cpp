#include "geometry/dual_path.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace ductus {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

} // namespace

DualPaths::DualPaths(const TriangleMesh &mesh, const MeshTopology &topology)
    : mMesh(mesh), mTopology(topology), mCentroids(mesh.triangles.size()),
      mDistance(mesh.triangles.size(), unreached), mViaEdge(mesh.triangles.size(), -1)
{
    for (int t = 0; t < mesh.triangleCount(); ++t)
        mCentroids[t] = mMesh.centroid(t);
}

// A* [Hart, Nilsson, Raphael 1968]: the straight line to the last centroid never overestimates, so the path
// is a shortest one and the search stays near the line. Ties go to the triangle with the lower number.
std::vector<int> DualPaths::crossedEdges(int from, int to, double maxLength, bool *found)
{
    if (found)
        *found = from == to;
    if (from == to)
        return {};

    for (int t : mTouched) {
        mDistance[t] = unreached;
        mViaEdge[t] = -1;
    }
    mTouched.clear();

    using Entry = std::pair<double, int>; // lower bound of the whole path through the triangle, triangle
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto remaining = [&](int t) { return (mCentroids[t] - mCentroids[to]).norm(); };
    mDistance[from] = 0.0;
    mTouched.push_back(from);
    queue.push({remaining(from), from});
    while (!queue.empty()) {
        const auto [bound, t] = queue.top();
        queue.pop();
        if (t == to)
            break;
        if (bound > mDistance[t] + remaining(t))
            continue; // a shorter way to t was found after this entry
        for (int e : mTopology.faceEdges[t]) {
            if (e < 0 || mTopology.edges[e].faceCount != 2)
                continue;
            const int next = mTopology.across(e, t);
            const double distance = mDistance[t] + (mCentroids[next] - mCentroids[t]).norm();
            const double nextBound = distance + remaining(next);
            if (!(distance < mDistance[next]) || nextBound > maxLength)
                continue;
            if (mDistance[next] == unreached)
                mTouched.push_back(next);
            mDistance[next] = distance;
            mViaEdge[next] = e;
            queue.push({nextBound, next});
        }
    }
    if (mDistance[to] == unreached)
        return {};

    if (found)
        *found = true;
    std::vector<int> crossed;
    for (int t = to; t != from; t = mTopology.across(crossed.back(), t))
        crossed.push_back(mViaEdge[t]);
    std::reverse(crossed.begin(), crossed.end());
    return crossed;
}

} // namespace ductus
