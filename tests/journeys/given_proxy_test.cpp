// "I have a rough mesh already": it is used; one that cannot be used is refused with the reason.
#include "journeys/sketch_journey.h"

#include "formats/mesh_file.h"
#include "geometry/mesh_topology.h"
#include "support/mesh_zoo.h"

#include <QTemporaryDir>
#include <QtTest>

#include <nlohmann/json.hpp>

using namespace ductus;
using Json = nlohmann::json;

class GivenProxyTest : public QObject
{
    Q_OBJECT
private slots:
    void goodOneIsUsed();
    void openOneGivesAnOpenSurface();
    void sickOneIsMendedOrRefused_data();
    void sickOneIsMendedOrRefused();
    void wrongFileIsRefused_data();
    void wrongFileIsRefused();

private:
    QTemporaryDir mFolder;
    QString path(const QString &name) const { return mFolder.filePath(name); }
};

namespace {

/// The mesh stretched into the box of a sketch, and \a shift times its diagonal beside it.
TriangleMesh fitted(TriangleMesh mesh, const StrokeSet &strokes, double shift = 0.0)
{
    const Box3 from = boundingBox(mesh.vertices), to = strokes.box();
    for (Vec3 &v : mesh.vertices) {
        const Vec3 share = (v - from.min).cwiseQuotient((from.max - from.min).cwiseMax(Vec3::Constant(1e-9)));
        v = to.min + share.cwiseProduct(to.max - to.min) + Vec3(shift * to.diagonal(), 0, 0);
    }
    return mesh;
}

bool write(const TriangleMesh &mesh, const QString &path)
{
    MeshFileContent content;
    content.mesh = mesh;
    return writeMesh(content, path.toStdString(), {}).ok();
}

} // namespace

void GivenProxyTest::goodOneIsUsed()
{
    const QString in = samplePath("computer-mouse"), out = path("good.obj"), report = path("good.json");
    QVERIFY(write(fitted(zoo::icosphere(4), strokesOf(in)), path("proxy.ply")));
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(in, out, {"--proxy", path("proxy.ply"), "--report", report}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const TriangleMesh mesh = meshOf(out);
    QCOMPARE(faultOfMesh(mesh), QString());
    QVERIFY(manifoldReport(mesh).isClosed());
    QCOMPARE(faultOfFit(strokesOf(in), mesh, 0.5), QString());
    const Json told = Json::parse(bytesOf(report).toStdString());
    QCOMPARE(told.at("proxy").at("kind").get<std::string>(), std::string("given"));
    QCOMPARE(told.at("proxy").at("open").get<bool>(), false);
}

void GivenProxyTest::openOneGivesAnOpenSurface()
{
    // The truth of the leaf is near enough a grid over its box seen from above.
    const QString in = samplePath("bent-leaf"), out = path("open.obj"), report = path("open.json");
    const ProgramRun first = runSketchSurfacer(surfaceArguments(in, path("first.obj")));
    QVERIFY2(first.exitCode == 0, first.told().constData());
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(in, out, {"--proxy", path("first.obj"), "--report", report}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const TriangleMesh mesh = meshOf(out);
    QCOMPARE(faultOfMesh(mesh), QString());
    QVERIFY(manifoldReport(mesh).borderEdges > 0);
    QCOMPARE(faultOfFit(strokesOf(in), mesh, 0.5), QString());
    QCOMPARE(Json::parse(bytesOf(report).toStdString()).at("proxy").at("open").get<bool>(), true);
}

void GivenProxyTest::sickOneIsMendedOrRefused_data()
{
    QTest::addColumn<QString>("mesh");
    for (const char *mesh : {"far away", "edges of three triangles", "touching solids", "inside out", "soup",
                             "one triangle", "one-sided"})
        QTest::newRow(mesh) << mesh;
}

void GivenProxyTest::sickOneIsMendedOrRefused()
{
    QFETCH(QString, mesh);
    const QString in = samplePath("computer-mouse");
    const StrokeSet strokes = strokesOf(in);
    const TriangleMesh ball = zoo::icosphere(3);
    TriangleMesh sick = mesh == "far away"                   ? fitted(ball, strokes, 50.0)
                        : mesh == "edges of three triangles" ? fitted(zoo::sheetWithFin(), strokes)
                        : mesh == "touching solids"          ? fitted(zoo::tetrahedraSharingEdge(), strokes)
                        : mesh == "inside out"               ? fitted(zoo::turnedOver(ball), strokes)
                        : mesh == "soup"                     ? fitted(zoo::exploded(ball), strokes)
                        : mesh == "one-sided"                ? fitted(zoo::moebiusStrip(), strokes)
                                              : TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}};
    QTemporaryDir folder;
    QVERIFY(write(sick, folder.filePath("proxy.obj")));
    RunOptions options;
    options.timeoutSeconds = 90;
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(in, folder.filePath("out.obj"), {"--proxy", folder.filePath("proxy.obj")}), options);
    QVERIFY2(!run.crashed && !run.hung, run.told().constData());
    qInfo("exit code %d after %.1f s; %s", run.exitCode, run.seconds,
          run.messages().isEmpty() ? "" : qPrintable(run.messages().last()));
    const bool mustSucceed = mesh == "inside out" || mesh == "soup"; // both say clearly what is meant
    QVERIFY2(run.exitCode == 0 || !mustSucceed, run.told().constData());
    if (run.exitCode == 0) {
        const TriangleMesh result = meshOf(folder.filePath("out.obj"));
        QCOMPARE(faultOfMesh(result), QString());
        QVERIFY2(faultOfFit(strokes, result, 3.5).isEmpty() ||
                     run.messages().join('\n').contains("does not follow the strokes"),
                 run.told().constData());
        QVERIFY2(mesh != "far away",
                 "strokes and proxy have nothing to do with each other, and that was not said");
    } else {
        const QString fault = faultOfRefusal(run, {"failed: "}, folder.path(), {"proxy.obj"});
        QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
    }
}

void GivenProxyTest::wrongFileIsRefused_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << "empty.obj" << QByteArray();
    QTest::newRow("garbage") << "garbage.ply" << QByteArray("ply\nformat ascii 1.0\nelement vertex many\n");
    QTest::newRow("noise") << "noise.stl" << QByteArray(200, '\xe7');
    QTest::newRow("no triangles") << "points.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    QTest::newRow("no area") << "flat.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    QTest::newRow("not a number") << "nan.off" << QByteArray("OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n");
    QTest::newRow("cut off") << "cut.off" << QByteArray("OFF\n3 1 0\n0 0 0\n1 0 0\n");
}

void GivenProxyTest::wrongFileIsRefused()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QTemporaryDir folder;
    QVERIFY(writeBytes(folder.filePath(name), content));
    const ProgramRun run = runSketchSurfacer(surfaceArguments(
        samplePath("bent-leaf"), folder.filePath("out.obj"), {"--proxy", folder.filePath(name)}));
    const QString fault = faultOfRefusal(run, {name}, folder.path(), {name});
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
}

QTEST_GUILESS_MAIN(GivenProxyTest)
#include "given_proxy_test.moc"
