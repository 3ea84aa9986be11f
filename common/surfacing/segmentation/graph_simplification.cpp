#include "surfacing/segmentation/graph_simplification.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

namespace ductus {

namespace {

class Clusters
{
public:
    Clusters(const Association &association, const MeshTopology &topology, std::span<const char> kept,
             std::span<const int> labels)
        : mLabels(labels), mParent(association.pointsOfVertex.size()), mSize(mParent.size(), 1),
          mIsAlone(mParent.size()), mNeighbours(mParent.size())
    {
        for (std::size_t v = 0; v < mParent.size(); ++v) {
            mParent[v] = int(v);
            mIsAlone[v] = !association.pointsOfVertex[v].empty() || (!kept.empty() && kept[v]);
        }
        for (const MeshEdge &edge : topology.edges) {
            mNeighbours[std::size_t(edge.v0)].push_back(edge.v1);
            mNeighbours[std::size_t(edge.v1)].push_back(edge.v0);
        }
        for (std::vector<int> &neighbours : mNeighbours)
            std::sort(neighbours.begin(), neighbours.end());
    }

    void join(int maxValence)
    {
        for (std::size_t v = 0; v < mParent.size(); ++v)
            for (int w : mNeighbours[v])
                if (int(v) < w)
                    offer(int(v), w, maxValence);
        while (!mOffers.empty()) {
            const auto [valence, size, a, b] = mOffers.top();
            mOffers.pop();
            if (mParent[std::size_t(a)] != a || mParent[std::size_t(b)] != b)
                continue; // offered again under its new name
            if (const int now = jointValence(a, b);
                now != valence || mSize[std::size_t(a)] + mSize[std::size_t(b)] != size) {
                offer(a, b, maxValence);
                continue;
            }
            contract(a, b);
            for (int w : mNeighbours[std::size_t(a)])
                offer(std::min(a, w), std::max(a, w), maxValence);
        }
    }

    int root(int v)
    {
        while (mParent[std::size_t(v)] != v) {
            mParent[std::size_t(v)] = mParent[std::size_t(mParent[std::size_t(v)])];
            v = mParent[std::size_t(v)];
        }
        return v;
    }

private:
    bool mayJoin(int a, int b) const
    {
        return !mIsAlone[std::size_t(a)] && !mIsAlone[std::size_t(b)] &&
               (mLabels.empty() || mLabels[std::size_t(a)] == mLabels[std::size_t(b)]);
    }

    // Of the cluster that a and b, neighbours, would make.
    int jointValence(int a, int b) const
    {
        const std::vector<int> &na = mNeighbours[std::size_t(a)], &nb = mNeighbours[std::size_t(b)];
        int common = 0;
        for (std::size_t i = 0, j = 0; i < na.size() && j < nb.size();) {
            if (na[i] == nb[j]) {
                ++common;
                ++i;
                ++j;
            } else if (na[i] < nb[j]) {
                ++i;
            } else {
                ++j;
            }
        }
        return int(na.size() + nb.size()) - common - 2;
    }

    void offer(int a, int b, int maxValence)
    {
        if (!mayJoin(a, b))
            return;
        const int valence = jointValence(a, b);
        if (valence <= maxValence)
            mOffers.push({valence, mSize[std::size_t(a)] + mSize[std::size_t(b)], a, b});
    }

    void contract(int a, int b) // b goes into a
    {
        std::vector<int> &na = mNeighbours[std::size_t(a)], &nb = mNeighbours[std::size_t(b)];
        std::vector<int> joint;
        std::set_union(na.begin(), na.end(), nb.begin(), nb.end(), std::back_inserter(joint));
        std::erase_if(joint, [&](int v) { return v == a || v == b; });
        for (int w : nb) {
            if (w == a)
                continue;
            std::vector<int> &nw = mNeighbours[std::size_t(w)];
            nw.erase(std::lower_bound(nw.begin(), nw.end(), b));
            const auto at = std::lower_bound(nw.begin(), nw.end(), a);
            if (at == nw.end() || *at != a)
                nw.insert(at, a);
        }
        na = std::move(joint);
        nb.clear();
        mParent[std::size_t(b)] = a;
        mSize[std::size_t(a)] += mSize[std::size_t(b)];
    }

    std::span<const int> mLabels;
    std::vector<int> mParent, mSize;
    std::vector<char> mIsAlone;
    std::vector<std::vector<int>> mNeighbours;    // of roots, sorted
    using Offer = std::tuple<int, int, int, int>; // joint valence, joint size, a < b
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> mOffers;
};

} // namespace

std::vector<int> SimplifiedGraph::ofVertices(const std::vector<int> &ofClusters) const
{
    std::vector<int> result(clusterOfVertex.size());
    for (std::size_t v = 0; v < result.size(); ++v)
        result[v] = ofClusters[std::size_t(clusterOfVertex[v])];
    return result;
}

SimplifiedGraph simplified(const Association &association, const MeshTopology &topology,
                           std::span<const char> kept, std::span<const int> labels,
                           const GraphSimplificationOptions &options)
{
    Clusters clusters(association, topology, kept, labels);
    clusters.join(options.maxValence);

    SimplifiedGraph graph{{}, MeshTopology(TriangleMesh{}), {}};
    std::vector<int> numberOfRoot(association.pointsOfVertex.size(), -1);
    Association &a = graph.association;
    for (std::size_t v = 0; v < numberOfRoot.size(); ++v) {
        int &number = numberOfRoot[std::size_t(clusters.root(int(v)))];
        if (number < 0) {
            number = int(a.pointsOfVertex.size());
            a.pointsOfVertex.push_back(association.pointsOfVertex[v]); // none for a cluster of several
            if (!association.vertices.empty())
                a.vertices.push_back(association.vertices[v]); // one direction a cluster is enough
            a.vertexCounts.push_back(0);
        }
        a.vertexCounts[std::size_t(number)] += int(association.countAt(v));
        graph.clusterOfVertex.push_back(number);
    }
    a.points = association.points;
    a.samples = association.samples;
    a.pairCount = association.pairCount;
    a.unreachedStrokes = association.unreachedStrokes;

    std::map<std::pair<int, int>, std::pair<double, char>> edges; // weight, crossed
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const int u = graph.clusterOfVertex[std::size_t(topology.edges[e].v0)];
        const int v = graph.clusterOfVertex[std::size_t(topology.edges[e].v1)];
        if (u == v)
            continue;
        auto &[weight, crossed] = edges[std::minmax(u, v)];
        weight += association.edgeWeights[e];
        crossed = char(crossed | association.edgeIsCrossed[e]);
    }
    graph.topology.vertexEdges.resize(a.pointsOfVertex.size());
    for (const auto &[ends, content] : edges) {
        MeshEdge edge;
        edge.v0 = ends.first;
        edge.v1 = ends.second;
        for (int v : {edge.v0, edge.v1})
            graph.topology.vertexEdges[std::size_t(v)].push_back(int(graph.topology.edges.size()));
        graph.topology.edges.push_back(edge);
        a.edgeWeights.push_back(content.first);
        a.edgeIsCrossed.push_back(content.second);
    }
    // Indices of samples are edges of the whole graph and mean nothing here.
    for (StrokeSample &sample : a.samples)
        sample.edge = -1;
    return graph;
}

} // namespace ductus
