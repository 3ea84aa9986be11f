// "Half of it is drawn twice" and "it is open here": mirror planes and boundary strokes.
#include "journeys/sketch_journey.h"

#include "geometry/hole_filling.h"
#include "geometry/mesh_topology.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

using namespace ductus;
using Json = nlohmann::json;

class SymmetryAndBorderTest : public QObject
{
    Q_OBJECT
private slots:
    void symmetricSketchGivesAMirroredMesh_data();
    void symmetricSketchGivesAMirroredMesh();
    void sketchWithoutPlaneSaysSo();
    void borderFollowsTheBoundaryStrokes();
};

namespace {

/// Vertices by place, on a grid of \a cell.
class Places
{
public:
    Places(const TriangleMesh &mesh, double cell) : mMesh(mesh), mCell(cell)
    {
        for (int v = 0; v < mesh.vertexCount(); ++v)
            mCells[key(mesh.vertices[std::size_t(v)], {0, 0, 0})].push_back(v);
    }

    /// All vertices within one cell's width of \a p.
    std::vector<int> near(const Vec3 &p) const
    {
        std::vector<int> found;
        for (int i = 0; i < 27; ++i) {
            const auto at = mCells.find(key(p, {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}));
            if (at == mCells.end())
                continue;
            for (int v : at->second)
                if ((mMesh.vertices[std::size_t(v)] - p).norm() <= mCell)
                    found.push_back(v);
        }
        return found;
    }

private:
    using Key = std::array<long, 3>;

    Key key(const Vec3 &p, const std::array<int, 3> &step) const
    {
        Key k;
        for (int i = 0; i < 3; ++i)
            k[std::size_t(i)] = std::lround(std::floor(p[i] / mCell)) + step[std::size_t(i)];
        return k;
    }

    const TriangleMesh &mMesh;
    double mCell;
    std::map<Key, std::vector<int>> mCells;
};

double distanceToPolyline(const Vec3 &p, const std::vector<Vec3> &line)
{
    double best = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 d = line[i + 1] - line[i];
        const double t = std::clamp((p - line[i]).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
        best = std::min(best, (line[i] + t * d - p).norm());
    }
    return best;
}

double share(std::vector<double> distances, double which)
{
    std::sort(distances.begin(), distances.end());
    return distances[std::size_t(which * double(distances.size() - 1))];
}

} // namespace

void SymmetryAndBorderTest::symmetricSketchGivesAMirroredMesh_data()
{
    QTest::addColumn<QString>("symmetry");
    QTest::addColumn<double>("tolerance"); // share of the diagonal; the plane found is told with six digits
    QTest::newRow("found") << "auto" << 5e-6;
    QTest::newRow("axis") << "z" << 1e-9;
    QTest::newRow("plane") << "0,0,-2,0" << 1e-9;
}

void SymmetryAndBorderTest::symmetricSketchGivesAMirroredMesh()
{
    QFETCH(QString, symmetry);
    QFETCH(double, tolerance);
    QTemporaryDir folder;
    const QString out = folder.filePath("car.obj"), reportPath = folder.filePath("car.json");
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(samplePath("car"), out, {"--symmetry", symmetry, "--report", reportPath}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const TriangleMesh mesh = meshOf(out);
    QCOMPARE(faultOfMesh(mesh), QString());
    QVERIFY2(manifoldReport(mesh).isClosed(), "the halves are welded");
    QCOMPARE(manifoldReport(mesh).components, 1);
    QCOMPARE(faultOfFit(strokesOf(samplePath("car")), mesh, 0.5), QString());

    Vec3 normal(0, 0, 1);
    double offset = 0.0;
    if (symmetry == "auto") {
        const Json told = Json::parse(bytesOf(reportPath).toStdString()).at("symmetry");
        for (int i = 0; i < 3; ++i)
            normal[i] = told.at("normal").at(std::size_t(i));
        offset = told.at("offset");
        QVERIFY2(std::abs(normal.z()) > 0.999, "the car is drawn symmetric in z");
        QVERIFY(told.at("matchedShare").get<double>() > 0.8);
        normal.normalize();
    }
    const double diagonal = boundingBox(mesh.vertices).diagonal();
    const Places exactly(mesh, 1e-9 * diagonal), nearly(mesh, tolerance * diagonal);
    std::vector<int> image(mesh.vertices.size(), -1);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 &p = mesh.vertices[std::size_t(v)];
        QVERIFY2(exactly.near(p).size() == 1, "two vertices at one place: not welded");
        const Vec3 mirrored = p - 2.0 * (normal.dot(p) - offset) * normal;
        const auto distance = [&](int u) { return (mesh.vertices[std::size_t(u)] - mirrored).norm(); };
        const std::vector<int> twins = nearly.near(mirrored);
        QVERIFY2(!twins.empty(), "a vertex without mirror image");
        image[std::size_t(v)] = *std::min_element(twins.begin(), twins.end(),
                                                  [&](int a, int b) { return distance(a) < distance(b); });
    }
    const auto turned = [](Triangle t) { // the same triangle begins with its smallest corner
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    std::set<Triangle> triangles;
    for (const Triangle &t : mesh.triangles)
        triangles.insert(turned(t));
    for (const Triangle &t : mesh.triangles)
        QVERIFY2(triangles.count(
                     turned({image[std::size_t(t[0])], image[std::size_t(t[2])], image[std::size_t(t[1])]})),
                 "a triangle without mirror image");
}

void SymmetryAndBorderTest::sketchWithoutPlaneSaysSo()
{
    QTemporaryDir folder;
    // The midrib and one side of the leaf: nothing to mirror.
    const QString in = folder.filePath("odd.curves");
    std::vector<std::vector<Vec3>> strokes;
    for (const Stroke &stroke : strokesOf(samplePath("bent-leaf")).strokes) {
        strokes.push_back(stroke.points);
        for (Vec3 &p : strokes.back())
            p += Vec3(0.9 * p.y() + 0.6 * p.z() * p.z(), 0.5 * p.x() * p.x(), 0.7 * p.x() + p.x() * p.y());
    }
    QVERIFY(writeBytes(in, curves(strokes)));
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(in, folder.filePath("out.obj"), {"--symmetry", "auto"}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    QVERIFY2(run.messages().join('\n').contains("No mirror plane was found"), run.told().constData());
    QCOMPARE(faultOfMesh(meshOf(folder.filePath("out.obj"))), QString());
}

void SymmetryAndBorderTest::borderFollowsTheBoundaryStrokes()
{
    QTemporaryDir folder;
    const std::vector<int> ids = {0, 1, 10, 11}; // as in samples.json
    const QString in = samplePath("bent-leaf"), out = folder.filePath("leaf.obj");
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(in, out, {"--boundary", "0-1,10,11", "--proxy-vertices", "6000"}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const TriangleMesh mesh = meshOf(out);
    const StrokeSet strokes = strokesOf(in);
    QCOMPARE(faultOfMesh(mesh), QString());
    QCOMPARE(faultOfFit(strokes, mesh, 0.5), QString());
    const std::vector<std::vector<int>> loops = borderLoops(mesh);
    QCOMPARE(loops.size(), std::size_t(1));

    std::vector<Vec3> border;
    for (int v : loops.front())
        border.push_back(mesh.vertices[std::size_t(v)]);
    border.push_back(Vec3(border.front()));
    const double diagonal = strokes.box().diagonal();
    std::vector<double> borderToStrokes, strokesToBorder;
    for (const Vec3 &p : border) {
        double best = 1e300;
        for (int id : ids)
            best = std::min(best, distanceToPolyline(p, strokes.strokes[std::size_t(id)].points));
        borderToStrokes.push_back(best / diagonal);
    }
    for (int id : ids)
        for (const Vec3 &p : strokes.strokes[std::size_t(id)].points)
            strokesToBorder.push_back(distanceToPolyline(p, border) / diagonal);
    qInfo("border to boundary strokes: 90 %% within %.2f %%, all within %.2f %%; strokes to border %.2f %%, "
          "%.2f %%",
          100 * share(borderToStrokes, 0.9), 100 * share(borderToStrokes, 1.0),
          100 * share(strokesToBorder, 0.9), 100 * share(strokesToBorder, 1.0));
    QVERIFY(share(borderToStrokes, 0.9) < 0.01);
    QVERIFY(share(strokesToBorder, 0.9) < 0.01);
    QVERIFY(share(borderToStrokes, 1.0) < 0.05);
    QVERIFY(share(strokesToBorder, 1.0) < 0.05);
}

QTEST_GUILESS_MAIN(SymmetryAndBorderTest)
#include "symmetry_and_border_test.moc"
