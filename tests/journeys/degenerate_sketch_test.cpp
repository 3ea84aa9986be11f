// "My sketch is odd": flat, tiny, huge, far away, doubled. It is surfaced, or refused with a reason; it never
// crashes.
#include "journeys/sketch_journey.h"

#include "geometry/mesh_topology.h"

#include <QTemporaryDir>
#include <QtTest>

#include <numbers>

using namespace ductus;

class DegenerateSketchTest : public QObject
{
    Q_OBJECT
private slots:
    void isSurfacedOrRefusedWithAReason_data();
    void isSurfacedOrRefusedWithAReason();
    void sizeAndPlaceDoNotMatter_data();
    void sizeAndPlaceDoNotMatter();
};

namespace {

using Strokes = std::vector<std::vector<Vec3>>;

std::vector<Vec3> circle(double radius, double height, int points = 40)
{
    std::vector<Vec3> stroke;
    for (int i = 0; i <= points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        stroke.push_back({radius * std::cos(angle), height, radius * std::sin(angle)});
    }
    return stroke;
}

Strokes sampleStrokes(const char *id)
{
    Strokes strokes;
    for (const Stroke &stroke : strokesOf(samplePath(QString::fromLatin1(id))).strokes)
        strokes.push_back(stroke.points);
    return strokes;
}

Strokes inPlane()
{
    Strokes strokes;
    for (double radius : {0.3, 0.6, 1.0})
        strokes.push_back(circle(radius, 0.25));
    return strokes;
}

Strokes doubledPoints(Strokes strokes)
{
    for (std::vector<Vec3> &stroke : strokes) {
        std::vector<Vec3> doubled;
        for (const Vec3 &p : stroke)
            doubled.insert(doubled.end(), 3, p);
        stroke = doubled;
    }
    return strokes;
}

Strokes repeated(const Strokes &strokes, int times)
{
    Strokes all;
    for (int i = 0; i < times; ++i)
        all.insert(all.end(), strokes.begin(), strokes.end());
    return all;
}

Strokes moved(Strokes strokes, double scale, const Vec3 &shift)
{
    for (std::vector<Vec3> &stroke : strokes)
        for (Vec3 &p : stroke)
            p = scale * p + shift;
    return strokes;
}

} // namespace

void DegenerateSketchTest::isSurfacedOrRefusedWithAReason_data()
{
    QTest::addColumn<QByteArray>("sketch");
    QTest::newRow("on one line") << curves({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{-3, -3, -3}, {5, 5, 5}}});
    QTest::newRow("one straight stroke") << curves({{{0, 0, 0}, {1, 0, 0}}});
    QTest::newRow("in one plane") << curves(inPlane());
    QTest::newRow("two strokes, one plane") << curves({circle(1.0, 0.0), circle(0.5, 0.0)});
    QTest::newRow("two strokes") << curves({circle(1.0, 0.0), circle(0.7, 1.0)});
    QTest::newRow("two crossing strokes") << curves({{{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 0.1}, {0, 1, 0.1}}});
    QTest::newRow("one point again and again") << curves({{{1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}}});
    QTest::newRow("every point three times") << curves(doubledPoints(sampleStrokes("bent-leaf")));
    QTest::newRow("thousands of the same strokes") << curves(repeated(sampleStrokes("bent-leaf"), 200));
    QTest::newRow("a stray stroke far away") << curves(repeated(sampleStrokes("bent-leaf"), 1)) +
                                                    curves({{{500, 0, 0}, {500, 1, 0}, {500, 1, 1}}});
    QTest::newRow("sizes near the end of numbers")
        << curves(moved(sampleStrokes("bent-leaf"), 1e300, Vec3::Zero()));
    QTest::newRow("sizes near zero") << curves(moved(sampleStrokes("bent-leaf"), 1e-300, Vec3::Zero()));
    QTest::newRow("so far away that digits are lost")
        << curves(moved(sampleStrokes("bent-leaf"), 1.0, Vec3(1e15, 1e15, 1e15)));
}

void DegenerateSketchTest::isSurfacedOrRefusedWithAReason()
{
    QFETCH(QByteArray, sketch);
    QTemporaryDir folder;
    const QString in = folder.filePath("odd.curves"), out = folder.filePath("out.obj");
    QVERIFY(writeBytes(in, sketch));
    RunOptions options;
    options.timeoutSeconds = 90;
    const ProgramRun run = runSketchSurfacer(surfaceArguments(in, out), options);
    QVERIFY2(!run.crashed && !run.hung, run.told().constData());
    qInfo("exit code %d after %.1f s; %s", run.exitCode, run.seconds,
          run.messages().isEmpty() ? "" : qPrintable(run.messages().last()));
    const QString row = QString::fromLatin1(QTest::currentDataTag());
    QVERIFY2(run.exitCode == 1 || row != "on one line", "a line has no surface");
    if (run.exitCode == 0) {
        QCOMPARE(faultOfMesh(meshOf(out)), QString());
    } else {
        const QString fault = faultOfRefusal(run, {"odd.curves", "failed: "}, folder.path(), {"odd.curves"});
        QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
    }
}

void DegenerateSketchTest::sizeAndPlaceDoNotMatter_data()
{
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("shift");
    QTest::newRow("a millionth") << 1e-6 << 0.0;
    QTest::newRow("a million times") << 1e6 << 0.0;
    QTest::newRow("far from the origin") << 1.0 << 1e5;
}

void DegenerateSketchTest::sizeAndPlaceDoNotMatter()
{
    QFETCH(double, scale);
    QFETCH(double, shift);
    QTemporaryDir folder;
    const QString in = folder.filePath("odd.curves"), out = folder.filePath("out.obj");
    QVERIFY(writeBytes(in, curves(moved(sampleStrokes("bent-leaf"), scale, Vec3::Constant(shift)))));
    const ProgramRun run = runSketchSurfacer(surfaceArguments(in, out));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const TriangleMesh mesh = meshOf(out);
    QCOMPARE(faultOfMesh(mesh), QString());
    QCOMPARE(faultOfFit(strokesOf(in), mesh, 0.5), QString());
    QVERIFY2(mesh.vertexCount() > 1000 && mesh.vertexCount() < 8000,
             qPrintable(QString::number(mesh.vertexCount())));
}

QTEST_GUILESS_MAIN(DegenerateSketchTest)
#include "degenerate_sketch_test.moc"
