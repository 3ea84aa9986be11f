#include "surfacing/segmentation/initial_models.h"

#include "support/mesh_zoo.h"

#include <QtTest>
#include <numeric>

using namespace ductus;

namespace {

constexpr double creaseX = 0.5;

// A roof: two planes that meet at x = 0.5, the crease between two columns of vertices. A stroke runs along
// the crease, others on the slopes.
struct Roof
{
    TriangleMesh mesh = zoo::grid(21);
    Association association;

    Roof()
    {
        for (Vec3 &p : mesh.vertices)
            p = on(p.x(), p.y());
        StrokeSet strokes;
        for (double x : {0.2, 0.35, creaseX, 0.65, 0.8}) {
            const double end = x == creaseX ? 0.0 : 0.15;
            Stroke stroke;
            for (int i = 0; i <= 60; ++i)
                stroke.points.push_back(on(x, end + (1.0 - 2.0 * end) * i / 60.0));
            strokes.strokes.push_back(stroke);
        }
        association = *associate(strokes, mesh, MeshTopology(mesh), {}, {});
    }

    static Vec3 on(double x, double y) { return {x, y, 0.5 - std::abs(x - creaseX)}; }
};

std::vector<ImplicitPolynomial> modelsOf(const Roof &roof, const SegmentationOptions &options,
                                         std::uint64_t seed)
{
    const auto embedding = proxyEmbedding(roof.association, MeshTopology(roof.mesh), options, {});
    return initialModels(roof.association, *embedding, options, Random(seed));
}

} // namespace

class InitialModelsTest : public QObject
{
    Q_OBJECT
private slots:
    void embeddingHasAColumnForEveryCluster();
    void oneModelAClusterThatHasPoints();
    void twoClustersPartAtTheCrease();
    void theSeedDecides();
    void boostIsApplied();
    void cancelledEmbedding();
};

void InitialModelsTest::embeddingHasAColumnForEveryCluster()
{
    const Roof roof;
    SegmentationOptions options;
    options.clusterCounts = {3, 9, 5};
    const auto embedding = proxyEmbedding(roof.association, MeshTopology(roof.mesh), options, {});
    QVERIFY(embedding.ok());
    QCOMPARE(embedding->rows(), Eigen::Index(roof.mesh.vertexCount()));
    QCOMPARE(embedding->cols(), Eigen::Index(9));
    QVERIFY(embedding->allFinite());
}

void InitialModelsTest::oneModelAClusterThatHasPoints()
{
    SegmentationOptions options;
    options.clusterCounts = {3, 6};
    options.initialDegrees = {3};
    const std::vector<ImplicitPolynomial> models = modelsOf(Roof(), options, 1);
    QVERIFY(models.size() >= 4 && models.size() <= 9);
    for (const ImplicitPolynomial &m : models) {
        QCOMPARE(m.degree, 3);
        QVERIFY(m.theta.allFinite());
    }
    // Every degree asked for is fitted to every cluster, none above the limit.
    options.initialDegrees = {1, 4};
    options.maxDegree = 2;
    int planes = 0, quadrics = 0;
    for (const ImplicitPolynomial &m : modelsOf(Roof(), options, 1)) {
        planes += m.degree == 1;
        quadrics += m.degree == 2;
    }
    QCOMPARE(planes, int(models.size()));
    QCOMPARE(quadrics, int(models.size()));
}

void InitialModelsTest::twoClustersPartAtTheCrease()
{
    const Roof roof;
    SegmentationOptions options;
    options.clusterCounts = {2};
    options.initialDegrees = {4};
    const std::vector<ImplicitPolynomial> models = modelsOf(roof, options, 1);
    QCOMPARE(models.size(), std::size_t(2));
    // Each slope is explained by one of the two.
    for (double x : {0.25, 0.75}) {
        double worst[2] = {0.0, 0.0};
        for (double dx : {-0.05, 0.0, 0.05})
            for (double y : {0.2, 0.5, 0.8})
                for (int m : {0, 1})
                    worst[m] = std::max(worst[m], std::abs(models[m].signedDistance(Roof::on(x + dx, y))));
        QVERIFY2(std::min(worst[0], worst[1]) < 0.02,
                 qPrintable(QString("%1 %2").arg(worst[0]).arg(worst[1])));
        QVERIFY(std::max(worst[0], worst[1]) > 0.05);
    }
}

void InitialModelsTest::theSeedDecides()
{
    const Roof roof;
    SegmentationOptions options;
    options.clusterCounts = {8};
    const auto first = modelsOf(roof, options, 3), again = modelsOf(roof, options, 3);
    QCOMPARE(first.size(), again.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        QVERIFY(first[i].theta == again[i].theta && first[i].origin == again[i].origin);
    bool differs = false;
    for (std::uint64_t seed = 4; seed < 8 && !differs; ++seed) {
        const auto other = modelsOf(roof, options, seed);
        differs = other.size() != first.size();
        for (std::size_t i = 0; i < first.size() && !differs; ++i)
            differs = other[i].origin != first[i].origin;
    }
    QVERIFY(differs);
}

void InitialModelsTest::boostIsApplied()
{
    const Roof roof;
    SegmentationOptions boosted, byHand;
    boosted.clusterCounts = byHand.clusterCounts = {4};
    boosted.initialBoost = 10.0;
    byHand.initialBoost = 1.0;
    byHand.fit.alignment *= 10.0;
    byHand.fit.regularisation *= 10.0;
    const auto a = modelsOf(roof, boosted, 1), b = modelsOf(roof, byHand, 1);
    QCOMPARE(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        QVERIFY((a[i].theta - b[i].theta).norm() <= 1e-9 * b[i].theta.norm());
}

void InitialModelsTest::cancelledEmbedding()
{
    const Roof roof;
    const std::atomic<bool> cancel = true;
    const auto embedding =
        proxyEmbedding(roof.association, MeshTopology(roof.mesh), {}, JobControl(&cancel, {}));
    QVERIFY(!embedding.ok());
    QVERIFY(embedding.error().isCancelled());
}

QTEST_APPLESS_MAIN(InitialModelsTest)
#include "initial_models_test.moc"
