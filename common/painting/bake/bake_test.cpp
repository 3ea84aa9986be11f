#include "painting/bake/bake.h"

#include "painting/bake/stroke_mesh.h"
#include "painting/coverage/stroke_segments.h"
#include "support/painting_scenes.h"

#include <QtTest>
#include <atomic>
#include <map>
#include <numbers>

using namespace ductus;

class BakeTest : public QObject
{
    Q_OBJECT
private slots:
    void strokesBecomeClosedMeshes_data();
    void strokesBecomeClosedMeshes();
    void verticesHaveTheColourOfTheirPoint();
    void finerEdgesGiveFinerMeshes();
    void hiddenStacksAreLeftOut();
    void refusesAndCancels();
};

void BakeTest::strokesBecomeClosedMeshes_data()
{
    QTest::addColumn<int>("section");
    QTest::newRow("round") << 0;
    QTest::newRow("ellipse") << 1;
    QTest::newRow("cube") << 2;
}

void BakeTest::strokesBecomeClosedMeshes()
{
    QFETCH(int, section);
    const StrokeShape stroke =
        evenStroke(StrokeSection(section), {{0, 0, 0}, {1, 0, 0}, {2, 0.2f, 0}}, 0.3f, {1, 1, 1});
    std::vector<SegmentData> segments;
    appendStrokeSegments(stroke, Eigen::Affine3d::Identity(), 0, std::nullopt, segments);
    const SkinMesh skin = strokeMesh(segments, 0.05);
    TriangleMesh mesh;
    for (const SkinVertex &vertex : skin.vertices)
        mesh.vertices.push_back(vertex.position);
    mesh.triangles = skin.triangles;
    std::map<std::pair<int, int>, int> edges; // by direction
    for (const Triangle &t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{t[i], t[(i + 1) % 3]}];
    int open = 0;
    for (const auto &[edge, count] : edges) {
        const auto other = edges.find({edge.second, edge.first});
        open += other == edges.end() || other->second != count;
    }
    // The poles of half balls are small rings, not points.
    QVERIFY2(open <= (section == 0 ? 200 : 0), qPrintable(QString::number(open)));
    const double length = 1 + std::hypot(1, 0.2), r = 0.3, pi = std::numbers::pi;
    const double expected = section == 0   ? pi * r * r * length + 4.0 / 3 * pi * r * r * r
                            : section == 1 ? pi * r * r * 0.3 * length
                                           : 4 * r * r * length;
    const double volume = signedVolume(mesh);
    QVERIFY2(std::abs(volume - expected) < 0.02 * expected,
             qPrintable(QString("%1 not %2").arg(volume).arg(expected)));
}

void BakeTest::verticesHaveTheColourOfTheirPoint()
{
    const PaintingScene scene = intersectionFromOutside();
    BakeOptions options;
    options.edgeLength = 0.03;
    const auto baked = bakePainting(scene.painting, options, {});
    QVERIFY(baked.ok());
    QCOMPARE(baked->size(), std::size_t(2));
    const BakedStack &tube = (*baked)[0];
    QCOMPARE(tube.colours.size(), tube.mesh.vertices.size());
    const Vec3 a(-0.5, 0.5, 0.2), b(0.6, -0.4, 0.2);
    int coloured = 0, plain = 0;
    for (std::size_t i = 0; i < tube.colours.size(); ++i) {
        const Vec3 &p = tube.mesh.vertices[i];
        const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        const double distance = (p - a - t * (b - a)).norm();
        if (std::abs(distance - 0.25) < 1e-4)
            continue;
        const Eigen::Vector4f expected =
            distance < 0.25 ? Eigen::Vector4f(0.1f, 0.25f, 0.8f, 1) : Eigen::Vector4f(0.85f, 0.8f, 0.7f, 1);
        QVERIFY((tube.colours[i] - expected).norm() < 1e-4f);
        ++(distance < 0.25 ? coloured : plain);
    }
    QVERIFY(coloured > 300 && plain > 300);
    for (const Eigen::Vector4f &colour : (*baked)[1].colours) // another stack's
        QVERIFY((colour - Eigen::Vector4f(0.1f, 0.55f, 0.15f, 1)).norm() < 1e-4f);
}

void BakeTest::finerEdgesGiveFinerMeshes()
{
    const PaintingScene scene = meshes();
    std::size_t last = 0;
    for (const double edge : {0.2, 0.1, 0.05}) {
        BakeOptions options;
        options.edgeLength = edge;
        const auto baked = bakePainting(scene.painting, options, {});
        QVERIFY(baked.ok() && baked->size() == 1);
        const TriangleMesh &mesh = (*baked)[0].mesh;
        for (const Triangle &t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY(
                    (mesh.vertices[std::size_t(t[i])] - mesh.vertices[std::size_t(t[(i + 1) % 3])]).norm() <=
                    edge);
        QVERIFY(mesh.vertices.size() > last);
        last = mesh.vertices.size();
        // Divided, not changed: the ball of triangles keeps its volume.
        QVERIFY(std::abs(signedVolume(mesh) - signedVolume(ballMesh(Vec3::Zero(), 0.6, {1, 1, 1}).mesh)) <
                1e-9);
    }
}

void BakeTest::hiddenStacksAreLeftOut()
{
    BakeOptions options;
    options.edgeLength = 0.2;
    const auto baked = bakePainting(hiddenLayers().painting, options, {});
    QVERIFY(baked.ok());
    QCOMPARE(baked->size(), std::size_t(1));
    QCOMPARE((*baked)[0].name, std::string("Plate"));
}

void BakeTest::refusesAndCancels()
{
    const Painting painting = intersectionFromOutside().painting;
    BakeOptions options;
    options.edgeLength = 0;
    QCOMPARE(bakePainting(painting, options, {}).error().code, ErrorCode::InvalidArgument);
    options.edgeLength = 0.001;
    options.maxVertices = 1000;
    QCOMPARE(bakePainting(painting, options, {}).error().code, ErrorCode::TooLarge);
    options.edgeLength = 0.05;
    options.maxVertices = 1000000;
    const std::atomic<bool> cancelled{true};
    QVERIFY(bakePainting(painting, options, JobControl(&cancelled, {})).error().isCancelled());
}

QTEST_APPLESS_MAIN(BakeTest)
#include "bake_test.moc"
