#include "surfacing/segmentation/graph_simplification.h"

#include "base/random.h"
#include "support/mesh_zoo.h"

#include <QtTest>
#include <set>

using namespace ductus;

namespace {

// A sphere with stroke points along one great circle and weights of any size.
struct Scene
{
    TriangleMesh mesh = zoo::icosphere(4);
    MeshTopology topology{mesh};
    Association association;

    Scene()
    {
        Random random(7);
        association.pointsOfVertex.resize(mesh.vertices.size());
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            if (std::abs(mesh.vertices[v].z()) < 0.05) {
                association.pointsOfVertex[v].push_back(int(association.points.size()));
                association.points.push_back({mesh.vertices[v], mesh.vertices[v]});
                association.samples.push_back({0, 0});
                ++association.pairCount;
            }
            association.vertices.push_back({mesh.vertices[v], mesh.vertices[v]});
        }
        for (std::size_t e = 0; e < topology.edges.size(); ++e) {
            association.edgeWeights.push_back(1.0 + 99.0 * random.uniform());
            association.edgeIsCrossed.push_back(0);
        }
    }
};

double cutWeight(const Association &association, const MeshTopology &topology, const std::vector<int> &labels)
{
    double sum = 0.0;
    for (std::size_t e = 0; e < topology.edges.size(); ++e)
        if (labels[std::size_t(topology.edges[e].v0)] != labels[std::size_t(topology.edges[e].v1)])
            sum += association.edgeWeights[e];
    return sum;
}

} // namespace

class GraphSimplificationTest : public QObject
{
    Q_OBJECT
private slots:
    void becomesMuchSmaller();
    void verticesWithStrokesStayAlone();
    void keptVerticesStayAlone();
    void labelsAreNotMixed();
    void valencesStayLow();
    void clustersAreConnected();
    void energiesAreThoseOfTheWholeGraph();
};

void GraphSimplificationTest::becomesMuchSmaller()
{
    const Scene scene;
    const SimplifiedGraph graph = simplified(scene.association, scene.topology, {}, {}, {});
    QVERIFY2(graph.association.pointsOfVertex.size() * 4 < scene.mesh.vertices.size(),
             qPrintable(QString::number(graph.association.pointsOfVertex.size())));
    QCOMPARE(graph.association.pairCount, scene.association.pairCount);
    QCOMPARE(graph.association.vertices.size(), graph.association.pointsOfVertex.size());
}

void GraphSimplificationTest::verticesWithStrokesStayAlone()
{
    const Scene scene;
    const SimplifiedGraph graph = simplified(scene.association, scene.topology, {}, {}, {});
    std::vector<int> size(graph.association.pointsOfVertex.size(), 0);
    for (int c : graph.clusterOfVertex)
        ++size[std::size_t(c)];
    for (std::size_t v = 0; v < scene.mesh.vertices.size(); ++v) {
        const std::size_t c = std::size_t(graph.clusterOfVertex[v]);
        QCOMPARE(graph.association.pointsOfVertex[c], scene.association.pointsOfVertex[v]);
        if (!scene.association.pointsOfVertex[v].empty())
            QCOMPARE(size[c], 1);
    }
}

void GraphSimplificationTest::keptVerticesStayAlone()
{
    const Scene scene;
    std::vector<char> kept(scene.mesh.vertices.size(), 0);
    for (std::size_t v = 0; v < kept.size(); v += 17)
        kept[v] = 1;
    const SimplifiedGraph graph = simplified(scene.association, scene.topology, kept, {}, {});
    std::vector<int> size(graph.association.pointsOfVertex.size(), 0);
    for (int c : graph.clusterOfVertex)
        ++size[std::size_t(c)];
    for (std::size_t v = 0; v < kept.size(); v += 17)
        QCOMPARE(size[std::size_t(graph.clusterOfVertex[v])], 1);
}

void GraphSimplificationTest::labelsAreNotMixed()
{
    const Scene scene;
    std::vector<int> labels;
    for (const Vec3 &v : scene.mesh.vertices)
        labels.push_back((v.x() > 0.1) + 2 * (v.y() > 0.3));
    const SimplifiedGraph graph = simplified(scene.association, scene.topology, {}, labels, {});
    std::vector<std::set<int>> labelsOf(graph.association.pointsOfVertex.size());
    for (std::size_t v = 0; v < labels.size(); ++v)
        labelsOf[std::size_t(graph.clusterOfVertex[v])].insert(labels[v]);
    for (const std::set<int> &of : labelsOf)
        QCOMPARE(of.size(), std::size_t(1));
}

void GraphSimplificationTest::valencesStayLow()
{
    const Scene scene;
    for (int most : {8, 12}) {
        const SimplifiedGraph graph = simplified(scene.association, scene.topology, {}, {}, {most});
        std::vector<int> size(graph.association.pointsOfVertex.size(), 0);
        for (int c : graph.clusterOfVertex)
            ++size[std::size_t(c)];
        for (std::size_t c = 0; c < size.size(); ++c)
            if (size[c] > 1)
                QVERIFY(int(graph.topology.vertexEdges[c].size()) <= most);
    }
}

void GraphSimplificationTest::clustersAreConnected()
{
    const Scene scene;
    const SimplifiedGraph graph = simplified(scene.association, scene.topology, {}, {}, {});
    std::vector<char> seen(scene.mesh.vertices.size(), 0);
    std::set<int> started;
    for (std::size_t start = 0; start < seen.size(); ++start) {
        if (seen[start])
            continue;
        QVERIFY2(started.insert(graph.clusterOfVertex[start]).second, "a cluster in two pieces");
        std::vector<int> queue{int(start)};
        seen[start] = 1;
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (int e : scene.topology.vertexEdges[std::size_t(queue[next])]) {
                const int w = scene.topology.neighbour(queue[next], e);
                if (!seen[std::size_t(w)] &&
                    graph.clusterOfVertex[std::size_t(w)] == graph.clusterOfVertex[start]) {
                    seen[std::size_t(w)] = 1;
                    queue.push_back(w);
                }
            }
    }
}

void GraphSimplificationTest::energiesAreThoseOfTheWholeGraph()
{
    const Scene scene;
    const SimplifiedGraph graph = simplified(scene.association, scene.topology, {}, {}, {});
    Random random(3);
    for (int trial = 0; trial < 5; ++trial) {
        std::vector<int> labels;
        for (std::size_t c = 0; c < graph.association.pointsOfVertex.size(); ++c)
            labels.push_back(random.index(4));
        const double coarse = cutWeight(graph.association, graph.topology, labels);
        const double whole = cutWeight(scene.association, scene.topology, graph.ofVertices(labels));
        QVERIFY(coarse > 0.0);
        QVERIFY(std::abs(coarse / whole - 1.0) < 1e-12);
    }
}

QTEST_GUILESS_MAIN(GraphSimplificationTest)
#include "graph_simplification_test.moc"
