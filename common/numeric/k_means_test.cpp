#include "numeric/k_means.h"

#include <QtTest>
#include <algorithm>
#include <set>

using namespace ductus;

namespace {

// clusters x perCluster points of three coordinates in tight blobs far apart; point i belongs to blob i %
// clusters.
Eigen::MatrixXd blobs(Random &random, int clusters, int perCluster)
{
    Eigen::MatrixXd points(3, clusters * perCluster);
    for (int i = 0; i < points.cols(); ++i) {
        const int blob = i % clusters;
        points.col(i) << 10.0 * (blob % 3) + 0.3 * random.normal(), 10.0 * (blob / 3) + 0.3 * random.normal(),
            0.3 * random.normal();
    }
    return points;
}

double sumOfSquares(const Eigen::MatrixXd &points, const std::vector<int> &clusters, int count)
{
    double sum = 0.0;
    for (int cluster = 0; cluster < count; ++cluster) {
        Eigen::VectorXd centre = Eigen::VectorXd::Zero(points.rows());
        int members = 0;
        for (int i = 0; i < points.cols(); ++i) {
            if (clusters[i] == cluster) {
                centre += points.col(i);
                ++members;
            }
        }
        for (int i = 0; i < points.cols(); ++i) {
            if (clusters[i] == cluster)
                sum += (points.col(i) - centre / members).squaredNorm();
        }
    }
    return sum;
}

} // namespace

class KMeansTest : public QObject
{
    Q_OBJECT
private slots:
    void separateBlobsAreFound();
    void noPointWouldDoBetterElsewhere();
    void awkwardCounts();
    void coincidentPointsShareACluster();
    void sameSeedSameClusters();
};

void KMeansTest::separateBlobsAreFound()
{
    Random random(1);
    const Eigen::MatrixXd points = blobs(random, 7, 90);
    // k-means++ may seed a blob twice; among a few seeds the best must be the truth.
    double best = 1e300;
    std::vector<int> found;
    for (int seed = 0; seed < 10; ++seed) {
        const std::vector<int> clusters = kMeans(points, 7, Random(std::uint64_t(seed)));
        const double sum = sumOfSquares(points, clusters, 7);
        if (sum < best) {
            best = sum;
            found = clusters;
        }
    }
    std::set<std::pair<int, int>> pairs;
    for (int i = 0; i < points.cols(); ++i)
        pairs.emplace(i % 7, found[i]);
    QCOMPARE(pairs.size(), std::size_t(7));
}

void KMeansTest::noPointWouldDoBetterElsewhere()
{
    Random random(2);
    Eigen::MatrixXd points(4, 700);
    for (Eigen::Index i = 0; i < points.size(); ++i)
        points(i) = random.uniform();
    KMeansOptions options;
    options.changedShare = 0.0;
    options.maxIterations = 1000;
    const std::vector<int> clusters = kMeans(points, 6, Random(3), options);
    Eigen::MatrixXd centres = Eigen::MatrixXd::Zero(4, 6);
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(6);
    for (int i = 0; i < 700; ++i) {
        centres.col(clusters[i]) += points.col(i);
        counts[clusters[i]] += 1.0;
    }
    QVERIFY(counts.minCoeff() > 0.0);
    for (int i = 0; i < 700; ++i) {
        const auto distance = [&](int c) {
            return (points.col(i) - centres.col(c) / counts[c]).squaredNorm();
        };
        for (int c = 0; c < 6; ++c)
            QVERIFY(distance(clusters[i]) <= distance(c) + 1e-12);
    }
}

void KMeansTest::awkwardCounts()
{
    Random random(4);
    const Eigen::MatrixXd points = blobs(random, 3, 2);
    for (int count : {-1, 0, 1})
        QCOMPARE(kMeans(points, count, random), std::vector<int>(6, 0));
    QVERIFY(kMeans(Eigen::MatrixXd(3, 0), 4, random).empty());
    // More clusters than points: every point has its own.
    const std::vector<int> clusters = kMeans(points, 9, random);
    QCOMPARE(std::set<int>(clusters.begin(), clusters.end()).size(), std::size_t(6));
    QVERIFY(*std::max_element(clusters.begin(), clusters.end()) < 9);
}

void KMeansTest::coincidentPointsShareACluster()
{
    Eigen::MatrixXd points = Eigen::MatrixXd::Zero(2, 30);
    points.rightCols(10).setConstant(1.0);
    const std::vector<int> clusters = kMeans(points, 5, Random(5));
    QCOMPARE(std::set<int>(clusters.begin(), clusters.end()).size(), std::size_t(2));
    QVERIFY(clusters[0] != clusters[29]);
    // Not a number: no crash, valid cluster numbers.
    points(0, 3) = std::numeric_limits<double>::quiet_NaN();
    for (int cluster : kMeans(points, 5, Random(5)))
        QVERIFY(cluster >= 0 && cluster < 5);
}

void KMeansTest::sameSeedSameClusters()
{
    Random random(6);
    Eigen::MatrixXd points(5, 3000);
    for (Eigen::Index i = 0; i < points.size(); ++i)
        points(i) = random.normal();
    const std::vector<int> first = kMeans(points, 12, Random(7));
    for (int run = 0; run < 3; ++run)
        QCOMPARE(kMeans(points, 12, Random(7)), first);
    QVERIFY(kMeans(points, 12, Random(8)) != first);
}

QTEST_APPLESS_MAIN(KMeansTest)
#include "k_means_test.moc"
