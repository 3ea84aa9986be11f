#include "base/random.h"
#include "numeric/sparse_cholesky.h"

#include <Eigen/Dense>
#include <QtTest>
#include <limits>

using namespace ductus;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

namespace {

SparseMatrix fromTriplets(int size, const std::vector<Triplet> &triplets)
{
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

// A random graph's Laplacian with random weights, plus a share of the identity: positive definite.
SparseMatrix randomMatrix(Random &random, int size, int edges, double shift)
{
    std::vector<Triplet> triplets;
    for (int v = 0; v < size; ++v)
        triplets.emplace_back(v, v, shift);
    for (int i = 0; i < edges; ++i) {
        const int u = random.index(size), v = random.index(size);
        const double weight = random.uniform(0.1, 2.0);
        if (u == v)
            continue;
        triplets.emplace_back(u, u, weight);
        triplets.emplace_back(v, v, weight);
        triplets.emplace_back(u, v, -weight);
        triplets.emplace_back(v, u, -weight);
    }
    return fromTriplets(size, triplets);
}

// L^T L + I on a triangulated torus, the matrix of Laplacian mesh deformation; block > 1 couples that many
// unknowns a vertex.
SparseMatrix squaredLaplacian(int width, int height, int block)
{
    const auto id = [&](int x, int y) { return (y + height) % height * width + (x + width) % width; };
    std::vector<Triplet> triplets;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            triplets.emplace_back(id(x, y), id(x, y), 1.0);
            for (int other :
                 {id(x + 1, y), id(x - 1, y), id(x, y + 1), id(x, y - 1), id(x + 1, y + 1), id(x - 1, y - 1)})
                triplets.emplace_back(id(x, y), other, -1.0 / 6.0);
        }
    }
    const SparseMatrix laplacian = fromTriplets(width * height, triplets);
    const SparseMatrix squared = SparseMatrix(laplacian.transpose()) * laplacian;
    triplets.clear();
    for (int column = 0; column < squared.cols(); ++column) {
        for (SparseMatrix::InnerIterator entry(squared, column); entry; ++entry) {
            for (int a = 0; a < block; ++a) {
                for (int b = 0; b < block; ++b)
                    triplets.emplace_back(entry.row() * block + a, column * block + b,
                                          entry.value() * (a == b ? 1.0 : 0.1));
            }
        }
    }
    for (int i = 0; i < squared.rows() * block; ++i)
        triplets.emplace_back(i, i, 1.0);
    return fromTriplets(int(squared.rows()) * block, triplets);
}

Eigen::MatrixXd randomColumns(Random &random, Eigen::Index rows, Eigen::Index columns)
{
    Eigen::MatrixXd result(rows, columns);
    for (Eigen::Index i = 0; i < result.size(); ++i)
        result(i) = random.normal();
    return result;
}

double relativeResidual(const SparseMatrix &matrix, const Eigen::MatrixXd &x, const Eigen::MatrixXd &b)
{
    return (matrix * x - b).norm() / b.norm();
}

} // namespace

class SparseCholeskyTest : public QObject
{
    Q_OBJECT
private slots:
    void agreesWithTheDenseSolution();
    void meshMatricesAreSolved_data();
    void meshMatricesAreSolved();
    void lowerTriangleIsEnough();
    void patternIsReusedAndItsChangeNoticed();
    void indefiniteMatricesAreRefused();
    void notANumberIsRefused();
    void deepTreesDoNotRecurse();
    void denseMatrixIsOneFront();
    void diagonalAndTinyMatrices();
    void manyColumnsEqualSingleOnes();
    void uncompressedMatricesWork();
    void sameInputSameBits();
};

void SparseCholeskyTest::agreesWithTheDenseSolution()
{
    Random random(1);
    for (int run = 0; run < 60; ++run) {
        const int size = 1 + random.index(150);
        // From a few edges (many components) to nearly full.
        const SparseMatrix matrix = randomMatrix(random, size, random.index(size * 8), 0.5);
        const Eigen::MatrixXd b = randomColumns(random, size, 3);
        SparseCholesky solver;
        QVERIFY(solver.factorize(matrix));
        const Eigen::MatrixXd expected = Eigen::MatrixXd(matrix).llt().solve(b);
        QVERIFY((solver.solve(b) - expected).norm() < 1e-10 * expected.norm());
    }
}

void SparseCholeskyTest::meshMatricesAreSolved_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("block");
    QTest::newRow("minimum degree") << 30 << 25 << 1;
    QTest::newRow("dissection") << 90 << 60 << 1;
    QTest::newRow("three unknowns a vertex") << 50 << 40 << 3; // fronts beyond one panel
}

void SparseCholeskyTest::meshMatricesAreSolved()
{
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, block);
    Random random(2);
    const SparseMatrix matrix = squaredLaplacian(width, height, block);
    const Eigen::MatrixXd b = randomColumns(random, matrix.rows(), 5);
    SparseCholesky solver;
    QVERIFY(solver.factorize(matrix));
    QVERIFY(relativeResidual(matrix, solver.solve(b), b) < 1e-12);
}

void SparseCholeskyTest::lowerTriangleIsEnough()
{
    Random random(3);
    const SparseMatrix matrix = squaredLaplacian(20, 20, 2);
    const SparseMatrix lower = matrix.triangularView<Eigen::Lower>();
    const Eigen::MatrixXd b = randomColumns(random, matrix.rows(), 2);
    SparseCholesky solver;
    QVERIFY(solver.factorize(lower));
    QVERIFY(relativeResidual(matrix, solver.solve(b), b) < 1e-12);
}

void SparseCholeskyTest::patternIsReusedAndItsChangeNoticed()
{
    Random random(4);
    SparseMatrix matrix = squaredLaplacian(20, 15, 1);
    const Eigen::MatrixXd b = randomColumns(random, matrix.rows(), 1);
    SparseCholesky solver;
    solver.analyze(matrix);
    for (int run = 0; run < 3; ++run) {
        matrix *= 1.7;
        QVERIFY(solver.factorize(matrix));
        QVERIFY(relativeResidual(matrix, solver.solve(b), b) < 1e-12);
    }
    // The same size and number of entries, other places.
    std::vector<Triplet> triplets;
    for (int column = 0; column < matrix.cols(); ++column) {
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            triplets.emplace_back((entry.row() + 7) % matrix.rows(), (column + 7) % matrix.cols(),
                                  entry.value());
    }
    const SparseMatrix shifted = fromTriplets(int(matrix.rows()), triplets);
    QVERIFY(solver.factorize(shifted));
    QVERIFY(relativeResidual(shifted, solver.solve(b), b) < 1e-12);
}

void SparseCholeskyTest::indefiniteMatricesAreRefused()
{
    SparseMatrix matrix = squaredLaplacian(40, 40, 1);
    SparseCholesky solver;
    QVERIFY(solver.factorize(matrix));
    for (int v : {0, 777, 1599}) {
        SparseMatrix spoiled = matrix;
        spoiled.coeffRef(v, v) = -1.0;
        QVERIFY(!solver.factorize(spoiled));
    }
    // A Laplacian alone is singular; take a little off and it is indefinite.
    Random random(5);
    QVERIFY(!solver.factorize(randomMatrix(random, 200, 900, -1e-3)));
    // The object is fit for use again.
    const Eigen::MatrixXd b = randomColumns(random, matrix.rows(), 1);
    QVERIFY(solver.factorize(matrix));
    QVERIFY(relativeResidual(matrix, solver.solve(b), b) < 1e-12);
}

void SparseCholeskyTest::notANumberIsRefused()
{
    for (double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        SparseMatrix matrix = squaredLaplacian(30, 30, 1);
        matrix.coeffRef(400, 400) = value;
        SparseCholesky solver;
        QVERIFY(!solver.factorize(matrix));
        matrix = squaredLaplacian(30, 30, 1);
        matrix.coeffRef(401, 400) = value;
        QVERIFY(!solver.factorize(matrix));
    }
}

void SparseCholeskyTest::deepTreesDoNotRecurse()
{
    const int size = 300000;
    std::vector<Triplet> triplets;
    for (int v = 0; v < size; ++v) {
        triplets.emplace_back(v, v, 2.5);
        if (v + 1 < size)
            triplets.emplace_back(v + 1, v, -1.0);
    }
    const SparseMatrix lower = fromTriplets(size, triplets);
    const Eigen::MatrixXd b = Eigen::MatrixXd::Ones(size, 1);
    SparseCholesky solver;
    QVERIFY(solver.factorize(lower));
    const SparseMatrix matrix = lower.selfadjointView<Eigen::Lower>();
    QVERIFY(relativeResidual(matrix, solver.solve(b), b) < 1e-12);
}

void SparseCholeskyTest::denseMatrixIsOneFront()
{
    Random random(6);
    const Eigen::MatrixXd root = randomColumns(random, 400, 400);
    const Eigen::MatrixXd dense = root * root.transpose() + Eigen::MatrixXd::Identity(400, 400);
    const SparseMatrix matrix = dense.sparseView();
    const Eigen::MatrixXd b = randomColumns(random, 400, 2);
    SparseCholesky solver;
    QVERIFY(solver.factorize(matrix));
    QVERIFY(relativeResidual(matrix, solver.solve(b), b) < 1e-9);
}

void SparseCholeskyTest::diagonalAndTinyMatrices()
{
    SparseCholesky solver;
    QVERIFY(solver.factorize(SparseMatrix(0, 0)));
    QCOMPARE(solver.solve(Eigen::MatrixXd(0, 2)).cols(), Eigen::Index(2));

    std::vector<Triplet> triplets;
    for (int v = 0; v < 5000; ++v)
        triplets.emplace_back(v, v, v + 1.0);
    const SparseMatrix diagonal = fromTriplets(5000, triplets);
    QVERIFY(solver.factorize(diagonal));
    const Eigen::MatrixXd x = solver.solve(Eigen::MatrixXd::Ones(5000, 1));
    for (int v = 0; v < 5000; ++v)
        QVERIFY(std::abs(x(v, 0) * (v + 1) - 1.0) < 1e-14);

    // A row that is not stored at all is a zero row.
    triplets.pop_back();
    QVERIFY(!solver.factorize(fromTriplets(5000, triplets)));
}

void SparseCholeskyTest::manyColumnsEqualSingleOnes()
{
    Random random(7);
    const SparseMatrix matrix = squaredLaplacian(40, 30, 1);
    const Eigen::MatrixXd b = randomColumns(random, matrix.rows(), 11);
    SparseCholesky solver;
    QVERIFY(solver.factorize(matrix));
    const Eigen::MatrixXd together = solver.solve(b);
    for (int column = 0; column < 11; ++column)
        QVERIFY((solver.solve(b.col(column)) - together.col(column)).norm() <
                1e-13 * together.col(column).norm());
    QCOMPARE(solver.solve(Eigen::MatrixXd(matrix.rows(), 0)).cols(), Eigen::Index(0));
}

void SparseCholeskyTest::uncompressedMatricesWork()
{
    Random random(8);
    SparseMatrix matrix(50, 50);
    matrix.reserve(Eigen::VectorXi::Constant(50, 6));
    for (int v = 0; v < 50; ++v) {
        matrix.insert(v, v) = 3.0;
        if (v > 0)
            matrix.insert(v, v - 1) = -1.0;
    }
    QVERIFY(!matrix.isCompressed());
    SparseCholesky solver;
    solver.analyze(matrix);
    QVERIFY(solver.factorize(matrix));
    const Eigen::MatrixXd b = randomColumns(random, 50, 1);
    const SparseMatrix both = matrix.selfadjointView<Eigen::Lower>();
    QVERIFY(relativeResidual(both, solver.solve(b), b) < 1e-13);
}

void SparseCholeskyTest::sameInputSameBits()
{
    Random random(9);
    const SparseMatrix matrix = squaredLaplacian(60, 40, 2);
    const Eigen::MatrixXd b = randomColumns(random, matrix.rows(), 6);
    Eigen::MatrixXd first;
    for (int run = 0; run < 4; ++run) {
        SparseCholesky solver;
        QVERIFY(solver.factorize(matrix));
        const Eigen::MatrixXd x = solver.solve(b);
        if (run == 0)
            first = x;
        QVERIFY(x == first);
    }
}

QTEST_APPLESS_MAIN(SparseCholeskyTest)
#include "sparse_cholesky_test.moc"
