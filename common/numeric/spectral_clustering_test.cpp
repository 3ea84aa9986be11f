#include "numeric/spectral_clustering.h"

#include <QtTest>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

using namespace ductus;

namespace {

// Triangulated grid of width x height vertices in patches of patch x patch, joined by weak edges.
std::vector<LabelingEdge> patchedGrid(int width, int height, int patch, double weak)
{
    std::vector<LabelingEdge> edges;
    const auto add = [&](int x, int y, int toX, int toY) {
        if (toX >= width || toY >= height)
            return;
        const bool same = x / patch == toX / patch && y / patch == toY / patch;
        edges.push_back({y * width + x, toY * width + toX, same ? 100.0 : weak});
    };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            add(x, y, x + 1, y);
            add(x, y, x, y + 1);
            add(x, y, x + 1, y + 1);
        }
    }
    return edges;
}

std::vector<LabelingEdge> ring(int first, int size)
{
    std::vector<LabelingEdge> edges;
    for (int i = 0; i < size; ++i)
        edges.push_back({first + i, first + (i + 1) % size, 2.5});
    return edges;
}

// x^T L x / x^T x by definition of the normalised Laplacian.
double rayleighQuotient(const std::vector<LabelingEdge> &edges, const Eigen::VectorXd &x)
{
    Eigen::VectorXd degrees = Eigen::VectorXd::Zero(x.size());
    for (const LabelingEdge &edge : edges) {
        degrees[edge.u] += edge.weight;
        degrees[edge.v] += edge.weight;
    }
    double sum = 0.0;
    for (const LabelingEdge &edge : edges) {
        const double difference =
            x[edge.u] / std::sqrt(degrees[edge.u]) - x[edge.v] / std::sqrt(degrees[edge.v]);
        sum += edge.weight * difference * difference;
    }
    return sum / x.squaredNorm();
}

} // namespace

class SpectralClusteringTest : public QObject
{
    Q_OBJECT
private slots:
    void ringHasItsKnownEigenvalues();
    void plantedPatchesAreFound();
    void componentsAreSeparated();
    void manyLikeComponentsKeepTheirOrder();
    void isolatedVerticesAreComponents();
    void fewerVerticesGiveFewerColumns();
    void malformedGraphsAreRefused_data();
    void malformedGraphsAreRefused();
    void cancelStops();
    void sameInputSameResult();
};

void SpectralClusteringTest::ringHasItsKnownEigenvalues()
{
    const int size = 800;
    const std::vector<LabelingEdge> edges = ring(0, size);
    const Result<Eigen::MatrixXd> embedding = spectralEmbedding(size, edges, 9, JobControl());
    QVERIFY(embedding.ok());
    QCOMPARE(embedding->cols(), Eigen::Index(9));
    for (int column = 0; column < 9; ++column) {
        const int frequency = (column + 1) / 2; // 0, then each twice
        const double expected = 1.0 - std::cos(2.0 * std::numbers::pi * frequency / size);
        QVERIFY(std::abs(rayleighQuotient(edges, embedding->col(column)) - expected) < 1e-9);
        Eigen::Index strongest = 0;
        embedding->col(column).cwiseAbs().maxCoeff(&strongest);
        QVERIFY((*embedding)(strongest, column) > 0.0);
    }
    QVERIFY((embedding->transpose() * *embedding - Eigen::MatrixXd::Identity(9, 9)).norm() < 1e-9);
}

void SpectralClusteringTest::plantedPatchesAreFound()
{
    const std::vector<LabelingEdge> edges = patchedGrid(60, 45, 15, 1.0);
    const Result<Eigen::MatrixXd> embedding = spectralEmbedding(60 * 45, edges, 12, JobControl());
    QVERIFY(embedding.ok());
    std::size_t mostPure = 0;
    for (int seed = 0; seed < 8; ++seed) {
        const std::vector<int> clusters = spectralClusters(*embedding, 12, Random(std::uint64_t(seed)));
        QCOMPARE(clusters.size(), std::size_t(60 * 45));
        std::set<std::pair<int, int>> pairs;
        for (int v = 0; v < 60 * 45; ++v)
            pairs.emplace((v / 60) / 15 * 4 + (v % 60) / 15, clusters[v]);
        std::set<int> used(clusters.begin(), clusters.end());
        // One cluster a patch: as many patch-cluster pairs as patches.
        if (pairs.size() == 12 && used.size() == 12)
            ++mostPure;
    }
    QVERIFY(mostPure >= 2);
}

void SpectralClusteringTest::componentsAreSeparated()
{
    std::vector<LabelingEdge> edges = ring(0, 500);
    for (const LabelingEdge &edge : ring(500, 300))
        edges.push_back(edge);
    const Result<Eigen::MatrixXd> embedding = spectralEmbedding(800, edges, 5, JobControl());
    QVERIFY(embedding.ok());
    const std::vector<int> clusters = spectralClusters(*embedding, 2, Random(1));
    for (int v = 0; v < 800; ++v)
        QCOMPARE(clusters[v], clusters[v < 500 ? 0 : 500]);
    QVERIFY(clusters[0] != clusters[500]);
    // The next eigenvalues are the longer ring's lowest pair, then the shorter one's.
    for (int column : {2, 3})
        QVERIFY(embedding->col(column).tail(300).isZero(0.0));
    QVERIFY(embedding->col(4).head(500).isZero(0.0)); // 1/300 < 2/500
}

void SpectralClusteringTest::manyLikeComponentsKeepTheirOrder()
{
    // 12 equal rings: eigenvalue 0 twelve times, the next one 24 times.
    std::vector<LabelingEdge> edges;
    for (int i = 0; i < 12; ++i) {
        for (const LabelingEdge &edge : ring(40 * i, 40))
            edges.push_back(edge);
    }
    const Result<Eigen::MatrixXd> embedding = spectralEmbedding(480, edges, 40, JobControl());
    QVERIFY(embedding.ok());
    for (int column = 0; column < 40; ++column) {
        const int frequency = column < 12 ? 0 : column < 36 ? 1 : 2;
        const double expected = 1.0 - std::cos(2.0 * std::numbers::pi * frequency / 40);
        QVERIFY(std::abs(rayleighQuotient(edges, embedding->col(column)) - expected) < 1e-10);
    }
    for (int i = 0; i < 12; ++i)
        QVERIFY((*embedding)(40 * i, i) > 0.0);
}

void SpectralClusteringTest::isolatedVerticesAreComponents()
{
    // Vertices 0 and 6 have no edge; an edge of no weight and a loop count as none.
    const std::vector<LabelingEdge> edges = {{1, 2, 1.0}, {2, 3, 1.0}, {4, 5, 1.0}, {5, 6, 0.0}, {0, 0, 3.0}};
    const Result<Eigen::MatrixXd> embedding = spectralEmbedding(7, edges, 4, JobControl());
    QVERIFY(embedding.ok());
    QCOMPARE(embedding->cols(), Eigen::Index(4));
    QVERIFY(embedding->allFinite());
    const std::vector<int> clusters = spectralClusters(*embedding, 4, Random(2));
    QCOMPARE(clusters[1], clusters[2]);
    QCOMPARE(clusters[2], clusters[3]);
    QCOMPARE(clusters[4], clusters[5]);
    QCOMPARE(std::set<int>(clusters.begin(), clusters.end()).size(), std::size_t(4));
    // Fewer vectors than components: the largest ones' come first, rows of the others are zero and still
    // clustered.
    const Result<Eigen::MatrixXd> two = spectralEmbedding(7, edges, 2, JobControl());
    QVERIFY(two.ok());
    QVERIFY(std::abs((*two)(1, 0)) > 0.1 && std::abs((*two)(4, 1)) > 0.1);
    QCOMPARE(spectralClusters(*two, 2, Random(3)).size(), std::size_t(7));
}

void SpectralClusteringTest::fewerVerticesGiveFewerColumns()
{
    const Result<Eigen::MatrixXd> embedding =
        spectralEmbedding(3, {{0, 1, 1.0}, {1, 2, 2.0}}, 50, JobControl());
    QVERIFY(embedding.ok());
    QCOMPARE(embedding->rows(), Eigen::Index(3));
    QCOMPARE(embedding->cols(), Eigen::Index(3));
    QCOMPARE(spectralClusters(*embedding, 50, Random(1)).size(), std::size_t(3));
    const Result<Eigen::MatrixXd> empty = spectralEmbedding(0, {}, 50, JobControl());
    QVERIFY(empty.ok());
    QCOMPARE(empty->size(), Eigen::Index(0));
    QVERIFY(spectralClusters(*empty, 50, Random(1)).empty());
}

void SpectralClusteringTest::malformedGraphsAreRefused_data()
{
    QTest::addColumn<int>("vertices");
    QTest::addColumn<int>("u");
    QTest::addColumn<double>("weight");
    QTest::addColumn<int>("count");
    QTest::newRow("negative vertex count") << -1 << 0 << 1.0 << 2;
    QTest::newRow("negative vector count") << 3 << 0 << 1.0 << -2;
    QTest::newRow("edge below") << 3 << -1 << 1.0 << 2;
    QTest::newRow("edge beyond") << 3 << 3 << 1.0 << 2;
    QTest::newRow("negative affinity") << 3 << 0 << -1.0 << 2;
    QTest::newRow("not a number") << 3 << 0 << std::numeric_limits<double>::quiet_NaN() << 2;
    QTest::newRow("infinite") << 3 << 0 << std::numeric_limits<double>::infinity() << 2;
}

void SpectralClusteringTest::malformedGraphsAreRefused()
{
    QFETCH(int, vertices);
    QFETCH(int, u);
    QFETCH(double, weight);
    QFETCH(int, count);
    const Result<Eigen::MatrixXd> embedding =
        spectralEmbedding(vertices, {{u, 1, weight}}, count, JobControl());
    QVERIFY(!embedding);
    QCOMPARE(embedding.error().code, ErrorCode::InvalidArgument);
}

void SpectralClusteringTest::cancelStops()
{
    const std::atomic<bool> cancelled = true;
    const Result<Eigen::MatrixXd> embedding =
        spectralEmbedding(900, ring(0, 900), 9, JobControl(&cancelled, {}));
    QVERIFY(!embedding);
    QVERIFY(embedding.error().isCancelled());
}

void SpectralClusteringTest::sameInputSameResult()
{
    const std::vector<LabelingEdge> edges = patchedGrid(50, 40, 10, 1.0);
    const Result<Eigen::MatrixXd> first = spectralEmbedding(2000, edges, 20, JobControl());
    const Result<Eigen::MatrixXd> second = spectralEmbedding(2000, edges, 20, JobControl());
    QVERIFY(first.ok() && second.ok());
    QVERIFY(*first == *second);
    QCOMPARE(spectralClusters(*first, 20, Random(4)), spectralClusters(*second, 20, Random(4)));
}

QTEST_APPLESS_MAIN(SpectralClusteringTest)
#include "spectral_clustering_test.moc"
