#include "surfacing/extraction/smoothness_operator.h"

#include "base/random.h"
#include "support/mesh_zoo.h"
#include "surfacing/extraction/half_mesh.h"

#include <Eigen/Dense>
#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

ImplicitPolynomial plane(const Vec3 &normal)
{
    ImplicitPolynomial model{1, Vec3::Zero(), Eigen::VectorXd::Zero(4)};
    model.theta.tail(3) = 5.0 * normal;
    return model;
}

// Of a vertex with labels 0 and 1 between planes that turn by \a angle.
double weightAt(double angle)
{
    SeamedMesh seamed;
    seamed.vertexLabels = {{0, 1}};
    const std::vector<ImplicitPolynomial> models{plane(Vec3::UnitZ()),
                                                 plane({std::sin(angle), 0, std::cos(angle)})};
    return smoothnessWeights(seamed, {Vec3::Zero()}, models, {})[0];
}

SeamedMesh stripes(const TriangleMesh &mesh)
{
    const MeshTopology topology(mesh);
    std::vector<int> labels;
    for (const Vec3 &p : mesh.vertices)
        labels.push_back(p.y() > 0.4);
    return insertSeams(mesh, topology, labels, std::vector<double>(topology.edges.size(), 0.5));
}

Eigen::VectorXd randomVector(Eigen::Index size, Random &random)
{
    Eigen::VectorXd x(size);
    for (Eigen::Index i = 0; i < size; ++i)
        x[i] = random.uniform(-1.0, 1.0);
    return x;
}

} // namespace

class SmoothnessOperatorTest : public QObject
{
    Q_OBJECT
private slots:
    void weightFallsWithTheAngle();
    void weightsByNumberOfLabels();
    void matrixIsTheEnergyByDefinition();
    void matrixIsSymmetricAndNeverNegative();
    void flatEvenMeshesAreSmooth();
    void inPlaneVerticesSeeBothHalves();
};

void SmoothnessOperatorTest::weightFallsWithTheAngle()
{
    constexpr double pi = std::numbers::pi;
    QVERIFY(std::abs(weightAt(0.0) - 1.0) < 1e-7);
    QVERIFY(std::abs(weightAt(0.99 * pi / 12) - 1.0) < 1e-12);
    QVERIFY(std::abs(weightAt(0.5 * (pi / 12 + pi / 6)) - 0.5) < 1e-9);
    QVERIFY(std::abs(weightAt(pi / 12 + 0.25 * (pi / 6 - pi / 12)) - 0.75) < 1e-9);
    for (double angle : {1.01 * pi / 6, pi / 2, 0.9 * pi, pi})
        QCOMPARE(weightAt(angle), 0.0);
}

void SmoothnessOperatorTest::weightsByNumberOfLabels()
{
    SeamedMesh seamed;
    seamed.vertexLabels = {{0}, {1}, {0, 1, 2}};
    const std::vector<ImplicitPolynomial> same(3, plane(Vec3::UnitZ()));
    const std::vector<double> weights =
        smoothnessWeights(seamed, std::vector<Vec3>(3, Vec3::Zero()), same, {});
    QCOMPARE(weights, (std::vector<double>{1.0, 1.0, 0.0}));
}

void SmoothnessOperatorTest::matrixIsTheEnergyByDefinition()
{
    const SeamedMesh seamed = stripes(zoo::grid(6, 0.1));
    const MeshTopology topology(seamed.mesh);
    Random random(4);
    std::vector<double> weights;
    for (int v = 0; v < seamed.mesh.vertexCount(); ++v)
        weights.push_back(random.uniform());
    const MeshOptimizationOptions options;
    const Eigen::SparseMatrix<double> matrix = smoothnessMatrix(seamed, topology, weights, {}, options);
    const std::vector<char> border = topology.borderVertices();
    for (int trial = 0; trial < 10; ++trial) {
        const Eigen::VectorXd x = randomVector(matrix.rows(), random);
        double energy = 0.0;
        for (int v = 0; v < seamed.mesh.vertexCount(); ++v) {
            double sum = 0.0;
            int count = 0;
            for (int e : topology.vertexEdges[v]) {
                if (border[v] && !topology.isBorder(e))
                    continue;
                sum += x[topology.neighbour(v, e)];
                ++count;
            }
            energy += options.surfaceSmoothness * weights[v] * std::pow(x[v] - sum / count, 2);
            double along = 0.0;
            int seamDegree = 0;
            for (const auto &[a, b] : seamed.seamEdges)
                if (a == v || b == v) {
                    along += x[a == v ? b : a];
                    ++seamDegree;
                }
            if (seamDegree == 2)
                energy += options.seamSmoothness * std::pow(x[v] - 0.5 * along, 2);
        }
        QVERIFY(std::abs(x.dot(matrix * x) - energy) < 1e-9 * energy);
    }
}

void SmoothnessOperatorTest::matrixIsSymmetricAndNeverNegative()
{
    const SeamedMesh seamed = stripes(zoo::icosphere(2));
    const std::vector<double> weights(seamed.mesh.vertices.size(), 1.0);
    const Eigen::MatrixXd matrix = smoothnessMatrix(seamed, MeshTopology(seamed.mesh), weights, {}, {});
    QVERIFY((matrix - matrix.transpose()).cwiseAbs().maxCoeff() < 1e-10);
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    QVERIFY(values[0] > -1e-9);
    QVERIFY(values[1] > 1e-6); // only a common shift of all vertices costs nothing
    QVERIFY((matrix * Eigen::VectorXd::Ones(matrix.rows())).norm() < 1e-9);
}

void SmoothnessOperatorTest::flatEvenMeshesAreSmooth()
{
    SeamedMesh seamed;
    seamed.mesh = zoo::grid(8);
    seamed.vertexLabels.assign(seamed.mesh.vertices.size(), {0});
    const MeshTopology topology(seamed.mesh);
    const std::vector<double> weights(seamed.mesh.vertices.size(), 1.0);
    const Eigen::SparseMatrix<double> matrix = smoothnessMatrix(seamed, topology, weights, {}, {});
    Eigen::VectorXd x(matrix.rows());
    for (Eigen::Index v = 0; v < x.size(); ++v)
        x[v] = seamed.mesh.vertices[std::size_t(v)].x();
    double corners = 0.0; // only the square's corners bend
    for (const Vec3 &p : seamed.mesh.vertices)
        if ((p.x() == 0.0 || p.x() == 1.0) && (p.y() == 0.0 || p.y() == 1.0))
            corners += 100.0 * std::pow(0.5 / 8, 2);
    QVERIFY(std::abs(x.dot(matrix * x) - corners) < 1e-12);
}

// A function that is even about the plane has the same Laplacian on the half as on the whole.
void SmoothnessOperatorTest::inPlaneVerticesSeeBothHalves()
{
    SeamedMesh half, whole;
    half.mesh = zoo::grid(5, 0.1);
    const SymmetryPlane mirror{Vec3::UnitX(), 0.0};
    const std::vector<char> inPlane = verticesInPlane(half.mesh, mirror);
    const MirroredMesh both = withMirrorImage(half.mesh, mirror, inPlane);
    whole.mesh = both.mesh;
    Random random(9);
    const Eigen::Index n = half.mesh.vertexCount();
    for (int trial = 0; trial < 5; ++trial) {
        const Eigen::VectorXd x = randomVector(n, random);
        Eigen::VectorXd even(whole.mesh.vertexCount());
        for (Eigen::Index v = 0; v < n; ++v)
            even[v] = even[both.imageOfVertex[std::size_t(v)]] = x[v];
        // Corners of the half where the plane meets the border are border vertices of the whole: left out of
        // both.
        std::vector<double> weights(std::size_t(n), 1.0), wholeWeights(std::size_t(even.size()), 0.0);
        for (Eigen::Index v = 0; v < n; ++v) {
            const Vec3 &p = half.mesh.vertices[std::size_t(v)];
            if (inPlane[std::size_t(v)] && (p.y() == 0.0 || p.y() == 1.0))
                weights[std::size_t(v)] = 0.0;
            wholeWeights[std::size_t(v)] = weights[std::size_t(v)];
        }
        const double halfEnergy =
            x.dot(smoothnessMatrix(half, MeshTopology(half.mesh), weights, inPlane, {}) * x);
        const double wholeEnergy =
            even.dot(smoothnessMatrix(whole, MeshTopology(whole.mesh), wholeWeights, {}, {}) * even);
        QVERIFY2(std::abs(halfEnergy - wholeEnergy) < 1e-9 * wholeEnergy,
                 qPrintable(QString("%1 %2").arg(halfEnergy).arg(wholeEnergy)));
    }
}

QTEST_APPLESS_MAIN(SmoothnessOperatorTest)
#include "smoothness_operator_test.moc"
