#include "base/random.h"
#include "numeric/lowest_eigenvectors.h"

#include <Eigen/Dense>
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

using namespace ductus;
using SparseMatrix = Eigen::SparseMatrix<double>;

namespace {

// I - W/degree on a torus of width x height vertices (a ring for height 1), whose eigenvalues are known.
SparseMatrix torusLaplacian(int width, int height)
{
    std::vector<Eigen::Triplet<double>> triplets;
    const double degree = height > 1 ? 4.0 : 2.0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int v = y * width + x;
            triplets.emplace_back(v, v, 1.0);
            triplets.emplace_back(v, y * width + (x + 1) % width, -1.0 / degree);
            triplets.emplace_back(v, y * width + (x + width - 1) % width, -1.0 / degree);
            if (height > 1) {
                triplets.emplace_back(v, (y + 1) % height * width + x, -1.0 / degree);
                triplets.emplace_back(v, (y + height - 1) % height * width + x, -1.0 / degree);
            }
        }
    }
    SparseMatrix matrix(width * height, width * height);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

std::vector<double> torusEigenvalues(int width, int height)
{
    std::vector<double> values;
    for (int a = 0; a < width; ++a) {
        for (int b = 0; b < height; ++b) {
            const double x = std::cos(2.0 * std::numbers::pi * a / width);
            const double y = std::cos(2.0 * std::numbers::pi * b / height);
            values.push_back(height > 1 ? 1.0 - (x + y) / 2.0 : 1.0 - x);
        }
    }
    std::sort(values.begin(), values.end());
    return values;
}

} // namespace

class LowestEigenvectorsTest : public QObject
{
    Q_OBJECT
private slots:
    void knownSpectraAreFound_data();
    void knownSpectraAreFound();
    void countIsLimitedToTheSize();
    void indefiniteMatrixHasNoSolution();
    void cancelStops();
    void sameInputSameBits();
};

void LowestEigenvectorsTest::knownSpectraAreFound_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("count");
    QTest::newRow("dense ring") << 120 << 1 << 9;
    QTest::newRow("ring") << 900 << 1 << 21;
    QTest::newRow("torus") << 50 << 31 << 30;
    QTest::newRow("square torus, multiplicity 8") << 45 << 45 << 50;
    QTest::newRow("one vector") << 40 << 30 << 1;
}

void LowestEigenvectorsTest::knownSpectraAreFound()
{
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, count);
    const SparseMatrix matrix = torusLaplacian(width, height);
    const Result<Eigenpairs> pairs = lowestEigenpairs(matrix, count, JobControl());
    QVERIFY(pairs.ok());
    const std::vector<double> expected = torusEigenvalues(width, height);
    QCOMPARE(pairs->values.size(), Eigen::Index(count));
    for (int i = 0; i < count; ++i)
        QVERIFY(std::abs(pairs->values[i] - expected[i]) < 1e-8);
    const Eigen::MatrixXd &vectors = pairs->vectors;
    QVERIFY((matrix * vectors - vectors * pairs->values.asDiagonal()).colwise().norm().maxCoeff() < 1e-6);
    QVERIFY((vectors.transpose() * vectors - Eigen::MatrixXd::Identity(count, count)).norm() < 1e-10);
}

void LowestEigenvectorsTest::countIsLimitedToTheSize()
{
    const Result<Eigenpairs> pairs = lowestEigenpairs(torusLaplacian(5, 1), 9, JobControl());
    QVERIFY(pairs.ok());
    QCOMPARE(pairs->vectors.cols(), Eigen::Index(5));
    const Result<Eigenpairs> none = lowestEigenpairs(torusLaplacian(5, 1), 0, JobControl());
    QVERIFY(none.ok());
    QCOMPARE(none->vectors.cols(), Eigen::Index(0));
}

void LowestEigenvectorsTest::indefiniteMatrixHasNoSolution()
{
    SparseMatrix matrix = torusLaplacian(40, 40);
    matrix.coeffRef(7, 7) = -1.0;
    const Result<Eigenpairs> pairs = lowestEigenpairs(matrix, 3, JobControl());
    QVERIFY(!pairs);
    QCOMPARE(pairs.error().code, ErrorCode::NoSolution);
}

void LowestEigenvectorsTest::cancelStops()
{
    const std::atomic<bool> cancelled = true;
    const Result<Eigenpairs> pairs = lowestEigenpairs(torusLaplacian(40, 40), 3, JobControl(&cancelled, {}));
    QVERIFY(!pairs);
    QVERIFY(pairs.error().isCancelled());
}

void LowestEigenvectorsTest::sameInputSameBits()
{
    const SparseMatrix matrix = torusLaplacian(45, 45);
    const Result<Eigenpairs> first = lowestEigenpairs(matrix, 20, JobControl());
    const Result<Eigenpairs> second = lowestEigenpairs(matrix, 20, JobControl());
    QVERIFY(first.ok() && second.ok());
    QVERIFY(first->vectors == second->vectors);
    QVERIFY(first->values == second->values);
}

QTEST_APPLESS_MAIN(LowestEigenvectorsTest)
#include "lowest_eigenvectors_test.moc"
