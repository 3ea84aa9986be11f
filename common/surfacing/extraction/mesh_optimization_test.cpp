#include "surfacing/extraction/mesh_optimization.h"

#include "base/random.h"
#include "support/mesh_zoo.h"
#include "surfacing/extraction/half_mesh.h"

#include <QtTest>

using namespace ductus;

namespace {

ImplicitPolynomial plane(const Vec3 &normal, double offset)
{
    ImplicitPolynomial model{1, Vec3::Zero(), Eigen::VectorXd(4)};
    model.theta << -3.0 * offset, 3.0 * normal.x(), 3.0 * normal.y(), 3.0 * normal.z();
    return model;
}

// x^2 + z^2 = r^2, or with y the sphere.
ImplicitPolynomial roundModel(double radius, bool isSphere)
{
    ImplicitPolynomial model{2, Vec3::Zero(), Eigen::VectorXd::Zero(10)};
    model.theta[0] = -radius * radius;
    model.theta[4] = model.theta[9] = 1.0;
    model.theta[7] = isSphere;
    return model;
}

// A sheet over [-0.35, 0.35]^2 lifted to \a height, seamed at x = 0 between two columns, and shaken.
template <typename Height>
SeamedMesh twoSheets(Height height, double noise)
{
    TriangleMesh mesh = zoo::grid(25);
    std::vector<int> labels;
    for (Vec3 &p : mesh.vertices) {
        p = 0.7 * (p - Vec3(0.5, 0.5, 0.0));
        p.z() = height(p.x());
        labels.push_back(p.x() > 0.0);
    }
    const MeshTopology topology(mesh);
    SeamedMesh seamed = insertSeams(mesh, topology, labels, std::vector<double>(topology.edges.size(), 0.5));
    Random random(3);
    for (Vec3 &p : seamed.mesh.vertices)
        p += noise * Vec3(random.normal(), random.normal(), random.normal());
    return seamed;
}

double roofHeight(double x)
{
    return 0.2 - std::abs(x);
}

const std::vector<ImplicitPolynomial> &roofModels()
{
    static const std::vector<ImplicitPolynomial> models{
        plane(Vec3(-1, 0, 1) / std::sqrt(2.0), 0.2 / std::sqrt(2.0)),
        plane(Vec3(1, 0, 1) / std::sqrt(2.0), 0.2 / std::sqrt(2.0))};
    return models;
}

// Borders are held where they are, as the pipeline does.
std::vector<BorderAttraction> held(const SeamedMesh &seamed)
{
    std::vector<BorderAttraction> targets;
    const std::vector<char> border = MeshTopology(seamed.mesh).borderVertices();
    for (std::size_t v = 0; v < border.size(); ++v)
        if (border[v])
            targets.push_back({int(v), seamed.mesh.vertices[v]});
    return targets;
}

OptimizedMesh optimized(const SeamedMesh &seamed, const std::vector<ImplicitPolynomial> &models,
                        const std::vector<BorderAttraction> &targets)
{
    Result<OptimizedMesh> result =
        optimizeMesh(seamed, models, targets, std::nullopt, {}, {}, {});
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return std::move(*result);
}

// Largest distance of a vertex \a rings or more away from the border to its models.
double worstDistance(const OptimizedMesh &result, const SeamedMesh &seamed,
                     const std::vector<ImplicitPolynomial> &models, int rings)
{
    const MeshTopology topology(result.mesh);
    std::vector<char> skipped = topology.borderVertices();
    for (int i = 1; i < rings; ++i) {
        std::vector<char> next = skipped;
        for (const MeshEdge &e : topology.edges)
            if (skipped[e.v0] || skipped[e.v1])
                next[e.v0] = next[e.v1] = 1;
        skipped = next;
    }
    double worst = 0.0;
    for (std::size_t v = 0; v < skipped.size(); ++v)
        for (int label : seamed.vertexLabels[v])
            if (!skipped[v])
                worst = std::max(worst, std::abs(models[label].signedDistance(result.mesh.vertices[v])));
    return worst;
}

} // namespace

class MeshOptimizationTest : public QObject
{
    Q_OBJECT
private slots:
    void noisyRoofEndsOnItsPlanes();
    void creaseStaysSharp();
    void tangentModelsAreSmoothedOver();
    void closedSphereKeepsItsShape();
    void connectivityIsKept();
    void borderIsDrawnToItsTargets();
    void withoutTargetsBordersStillEnd();
    void inPlaneVerticesStayInThePlane();
    void strayModelPullsLittle();
    void sameInputSameMesh();
    void cancelled();
};

void MeshOptimizationTest::noisyRoofEndsOnItsPlanes()
{
    const SeamedMesh exact = twoSheets(roofHeight, 0.0), noisy = twoSheets(roofHeight, 0.004);
    const OptimizedMesh result = optimized(noisy, roofModels(), held(exact));
    const double before = worstDistance({noisy.mesh, {}, 0}, noisy, roofModels(), 1);
    // Beside the held border its targets and the even spacing that smoothing asks for contradict each other.
    const double after = worstDistance(result, noisy, roofModels(), 6);
    QVERIFY(before > 0.008);
    QVERIFY2(after < 1e-3, qPrintable(QString::number(after)));
    QVERIFY(result.rounds >= 1);
}

void MeshOptimizationTest::creaseStaysSharp()
{
    const SeamedMesh exact = twoSheets(roofHeight, 0.0), noisy = twoSheets(roofHeight, 0.004);
    const OptimizedMesh result = optimized(noisy, roofModels(), held(exact));
    const MeshTopology topology(result.mesh);
    int creaseEdges = 0;
    for (const auto &[a, b] : noisy.seamEdges) {
        if (std::abs(exact.mesh.vertices[a].y()) > 0.25 || std::abs(exact.mesh.vertices[b].y()) > 0.25)
            continue;
        const int edge = topology.edgeBetween(a, b);
        const double turn = result.mesh.faceNormal(topology.edges[edge].faces[0])
                                .dot(result.mesh.faceNormal(topology.edges[edge].faces[1]));
        QVERIFY2(std::abs(turn) < 0.02, qPrintable(QString::number(turn))); // 90 degrees
        QCOMPARE(result.seamSharpness[a], 1.0);
        QVERIFY(std::abs(result.mesh.vertices[a].x()) < 1e-3);
        ++creaseEdges;
    }
    QVERIFY(creaseEdges > 15);
    for (std::size_t v = 0; v < noisy.vertexLabels.size(); ++v)
        if (noisy.vertexLabels[v].size() == 1)
            QCOMPARE(result.seamSharpness[v], 0.0);
}

void MeshOptimizationTest::tangentModelsAreSmoothedOver()
{
    // The plane z = 0.5 runs into the cylinder of radius 0.5 around y.
    const auto height = [](double x) { return x < 0.0 ? 0.5 : std::sqrt(0.25 - x * x); };
    const std::vector<ImplicitPolynomial> models{plane(Vec3::UnitZ(), 0.5), roundModel(0.5, false)};
    const SeamedMesh exact = twoSheets(height, 0.0), noisy = twoSheets(height, 0.004);
    const OptimizedMesh result = optimized(noisy, models, held(exact));
    for (double s : result.seamSharpness)
        QVERIFY(s < 1e-9);
    // Smoothing with gamma_2D = 100 flattens the cylinder a little.
    QVERIFY2(worstDistance(result, noisy, models, 6) < 3e-3,
             qPrintable(QString::number(worstDistance(result, noisy, models, 6))));
    const MeshTopology topology(result.mesh);
    for (const auto &[a, b] : noisy.seamEdges) {
        const int edge = topology.edgeBetween(a, b);
        QVERIFY(result.mesh.faceNormal(topology.edges[edge].faces[0])
                    .dot(result.mesh.faceNormal(topology.edges[edge].faces[1])) > std::cos(0.2));
    }
}

void MeshOptimizationTest::closedSphereKeepsItsShape()
{
    SeamedMesh seamed;
    seamed.mesh = zoo::icosphere(4);
    Random random(1);
    for (Vec3 &p : seamed.mesh.vertices)
        p = 0.4 * (1.0 + 0.02 * random.normal()) * p;
    seamed.triangleLabels.assign(seamed.mesh.triangles.size(), 0);
    seamed.vertexLabels.assign(seamed.mesh.vertices.size(), {0});
    const OptimizedMesh result = optimized(seamed, {roundModel(0.4, true)}, {});
    double mean = 0.0, worst = 0.0;
    for (const Vec3 &p : result.mesh.vertices) {
        mean += p.norm() / double(result.mesh.vertices.size());
        worst = std::max(worst, std::abs(p.norm() - 0.4));
    }
    QVERIFY2(std::abs(mean - 0.4) < 1e-3, qPrintable(QString::number(mean)));
    QVERIFY2(worst < 2e-3, qPrintable(QString::number(worst)));
    QVERIFY(manifoldReport(result.mesh).isClosed());
    QVERIFY(signedVolume(result.mesh) > 0.0);
}

void MeshOptimizationTest::connectivityIsKept()
{
    const SeamedMesh noisy = twoSheets(roofHeight, 0.004);
    const OptimizedMesh result = optimized(noisy, roofModels(), held(noisy));
    QVERIFY(result.mesh.triangles == noisy.mesh.triangles);
    QCOMPARE(result.mesh.vertices.size(), noisy.mesh.vertices.size());
    QCOMPARE(result.seamSharpness.size(), noisy.mesh.vertices.size());
    for (const Vec3 &p : result.mesh.vertices)
        QVERIFY(p.allFinite());
}

void MeshOptimizationTest::borderIsDrawnToItsTargets()
{
    // One side of a flat sheet is to be drawn out along an arc in the plane.
    const auto flat = [](double) { return 0.0; };
    const SeamedMesh sheet = twoSheets(flat, 0.0);
    const std::vector<ImplicitPolynomial> models(2, plane(Vec3::UnitZ(), 0.0));
    std::vector<BorderAttraction> targets = held(sheet);
    for (BorderAttraction &t : targets)
        if (t.target.x() > 0.349)
            t.target.x() += 0.03 * std::cos(t.target.y() / 0.35 * 1.5);
    const auto worst = [&](const OptimizedMesh &result) {
        double distance = 0.0;
        for (const BorderAttraction &t : targets) {
            const bool isCorner = std::abs(t.target.y()) > 0.33 || std::abs(t.target.x()) < 0.05;
            if (!isCorner)
                distance = std::max(distance, (result.mesh.vertices[t.vertex] - t.target).norm());
        }
        return distance;
    };
    const double attracted = worst(optimized(sheet, models, targets)),
                 held0 = worst(optimized(sheet, models, held(sheet)));
    QVERIFY2(attracted < 0.015, qPrintable(QString::number(attracted)));
    QVERIFY2(attracted < 0.5 * held0, qPrintable(QString::number(held0)));
}

void MeshOptimizationTest::withoutTargetsBordersStillEnd()
{
    const SeamedMesh sheet = twoSheets(roofHeight, 0.002);
    const OptimizedMesh result = optimized(sheet, roofModels(), {});
    for (const Vec3 &p : result.mesh.vertices)
        QVERIFY(p.allFinite() && p.norm() < 1.0);
    QVERIFY(manifoldReport(result.mesh).isManifold());
}

void MeshOptimizationTest::inPlaneVerticesStayInThePlane()
{
    const SymmetryPlane mirror{Vec3(3, 0, 4) / 5.0, 0.05};
    SeamedMesh seamed;
    TriangleMesh ball = zoo::icosphere(3);
    for (Vec3 &p : ball.vertices)
        p *= 0.4;
    seamed.mesh = keptHalf(ball, mirror);
    const std::vector<char> inPlane = verticesInPlane(seamed.mesh, mirror);
    Random random(5);
    for (std::size_t v = 0; v < inPlane.size(); ++v) {
        seamed.mesh.vertices[v] += 0.005 * Vec3(random.normal(), random.normal(), random.normal());
        if (inPlane[v])
            seamed.mesh.vertices[v] = mirror.projected(seamed.mesh.vertices[v]);
    }
    seamed.triangleLabels.assign(seamed.mesh.triangles.size(), 0);
    seamed.vertexLabels.assign(seamed.mesh.vertices.size(), {0});
    // A model that would draw the border out of the plane: the ball beside its place.
    const Vec3 shift = 0.02 * mirror.normal;
    ImplicitPolynomial shifted = roundModel(0.4, true);
    shifted.origin = shift;
    const auto result = optimizeMesh(seamed, {shifted}, {}, mirror, inPlane, {}, {});
    QVERIFY(result.ok());
    double moved = 0.0;
    for (std::size_t v = 0; v < inPlane.size(); ++v)
        if (inPlane[v]) {
            QVERIFY(std::abs(mirror.signedDistance(result->mesh.vertices[v])) < 1e-14);
            moved = std::max(moved, (result->mesh.vertices[v] - seamed.mesh.vertices[v]).norm());
        }
    QVERIFY(moved > 1e-3); // they slide in it
    // Mirrored, the surface has no crease there: triangles at the border stand at right angles to the plane,
    // but for the angle the models meet it with.
    const MirroredMesh whole = withMirrorImage(result->mesh, mirror, inPlane);
    QVERIFY(manifoldReport(whole.mesh).isClosed());
}

void MeshOptimizationTest::strayModelPullsLittle()
{
    // One of two sheets has a model that is half a diagonal away.
    const auto flat = [](double) { return 0.0; };
    const SeamedMesh sheet = twoSheets(flat, 0.0);
    const OptimizedMesh result =
        optimized(sheet, {plane(Vec3::UnitZ(), 0.0), plane(Vec3::UnitZ(), 0.5)}, held(sheet));
    for (const Vec3 &p : result.mesh.vertices)
        QVERIFY(p.allFinite() && std::abs(p.z()) < 0.6);
}

void MeshOptimizationTest::sameInputSameMesh()
{
    const SeamedMesh noisy = twoSheets(roofHeight, 0.004);
    const OptimizedMesh first = optimized(noisy, roofModels(), held(noisy)),
                        again = optimized(noisy, roofModels(), held(noisy));
    QVERIFY(first.mesh.vertices == again.mesh.vertices);
    QCOMPARE(first.rounds, again.rounds);
}

void MeshOptimizationTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    const SeamedMesh noisy = twoSheets(roofHeight, 0.004);
    const auto result = optimizeMesh(noisy, roofModels(), {}, std::nullopt, {}, {},
                                     JobControl(&cancel, {}));
    QVERIFY(!result.ok());
    QVERIFY(result.error().isCancelled());
}

QTEST_APPLESS_MAIN(MeshOptimizationTest)
#include "mesh_optimization_test.moc"
