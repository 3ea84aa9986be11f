#include "surfacing/pipeline/local_attraction.h"

#include "geometry/nearest.h"
#include "surfacing/extraction/half_mesh.h"

#include <QtTest>

using namespace ductus;

namespace {

// A flat sheet, 1 by 1 in the plane z = 0, symmetric to x = 0.
TriangleMesh sheet()
{
    constexpr int cells = 50;
    TriangleMesh mesh;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j)
            mesh.vertices.push_back({double(i) / cells - 0.5, double(j) / cells - 0.5, 0.0});
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const int a = i * (cells + 1) + j, b = a + cells + 1;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    return mesh;
}

StrokeSet lineAt(double y, double z, double from, double to)
{
    Stroke stroke;
    for (double x = from; x <= to + 1e-9; x += 0.01)
        stroke.points.push_back({x, y, z});
    StrokeSet set;
    set.strokes = {stroke};
    return set;
}

TriangleMesh pulled(const TriangleMesh &mesh, const StrokeSet &strokes, const std::vector<Vec3> &changed,
                    const std::optional<SymmetryPlane> &plane = std::nullopt)
{
    Result<TriangleMesh> result = attractedNear(mesh, strokes, changed, plane, {}, {});
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return std::move(*result);
}

} // namespace

class LocalAttractionTest : public QObject
{
    Q_OBJECT
private slots:
    void sheetMeetsTheStroke();
    void farVerticesStayExactly();
    void strokesThatDidNotChangeHoldTheSheet();
    void halfKeepsItsBorderInThePlane();
    void foldingIsRefused();
    void cancelIsHeard();
};

void LocalAttractionTest::sheetMeetsTheStroke()
{
    const StrokeSet stroke = lineAt(0.0, 0.04, -0.1, 0.1);
    const TriangleMesh moved = pulled(sheet(), stroke, stroke.allPoints());
    const NearestOnMesh nearest(moved);
    for (const Vec3 &p : stroke.allPoints())
        QVERIFY2(nearest.nearest(p).distance < 0.006,
                 qPrintable(QString::number(nearest.nearest(p).distance)));
    QCOMPARE(moved.triangles, sheet().triangles);
}

void LocalAttractionTest::farVerticesStayExactly()
{
    const StrokeSet stroke = lineAt(0.0, 0.04, -0.1, 0.1);
    const TriangleMesh before = sheet(), moved = pulled(before, stroke, stroke.allPoints());
    int stayed = 0;
    for (std::size_t v = 0; v < before.vertices.size(); ++v) {
        double distance = 1.0;
        for (const Vec3 &p : stroke.allPoints())
            distance = std::min(distance, (p - before.vertices[v]).norm());
        if (distance >= LocalAttractionOptions().none) {
            QCOMPARE(moved.vertices[v], before.vertices[v]);
            ++stayed;
        }
    }
    QVERIFY(stayed > 500);
}

void LocalAttractionTest::strokesThatDidNotChangeHoldTheSheet()
{
    const StrokeSet added = lineAt(0.0, 0.04, -0.1, 0.1), old = lineAt(0.07, 0.0, -0.2, 0.2);
    StrokeSet all = added;
    all.strokes.push_back(old.strokes[0]);
    const NearestOnMesh with(pulled(sheet(), all, added.allPoints()));
    const NearestOnMesh without(pulled(sheet(), added, added.allPoints()));
    double farthestWith = 0.0, farthestWithout = 0.0;
    for (const Vec3 &p : old.allPoints()) {
        farthestWith = std::max(farthestWith, with.nearest(p).distance);
        farthestWithout = std::max(farthestWithout, without.nearest(p).distance);
    }
    QVERIFY2(farthestWith < 0.4 * farthestWithout,
             qPrintable(QString("%1 %2").arg(farthestWith).arg(farthestWithout)));
}

void LocalAttractionTest::halfKeepsItsBorderInThePlane()
{
    const SymmetryPlane plane{Vec3::UnitX(), 0.0};
    const TriangleMesh half = keptHalf(sheet(), plane);
    const StrokeSet stroke = lineAt(0.0, 0.04, 0.0, 0.1);
    const TriangleMesh moved = pulled(half, stroke, stroke.allPoints(), plane);
    const std::vector<char> inPlane = verticesInPlane(half, plane);
    double highest = 0.0;
    int count = 0;
    for (std::size_t v = 0; v < inPlane.size(); ++v)
        if (inPlane[v]) {
            ++count;
            QVERIFY(std::abs(moved.vertices[v].x()) < 1e-12);
            highest = std::max(highest, moved.vertices[v].z());
        }
    QVERIFY(count > 20);
    QVERIFY2(highest > 0.03, qPrintable(QString::number(highest))); // the border follows, as the whole would
}

void LocalAttractionTest::foldingIsRefused()
{
    // Each point pulls its foot a long way along a narrow fold.
    TriangleMesh bent = sheet();
    for (Vec3 &p : bent.vertices)
        if (p.y() > 0.0)
            p = Vec3(p.x(), 0.06 * std::sin(p.y() / 0.02), 0.06 * (1.0 - std::cos(p.y() / 0.02)));
    StrokeSet strokes;
    for (double z : {0.0, 0.03, 0.06, 0.09, 0.12}) {
        const StrokeSet line = lineAt(z > 0.05 ? -0.05 : 0.05, z, -0.1, 0.1);
        strokes.strokes.push_back(line.strokes[0]);
    }
    const Result<TriangleMesh> moved =
        attractedNear(bent, strokes, strokes.allPoints(), std::nullopt, {}, {});
    QVERIFY(!moved.ok());
    QCOMPARE(moved.error().code, ErrorCode::NoSolution);
    QVERIFY(!moved.error().remedy.empty());
}

void LocalAttractionTest::cancelIsHeard()
{
    const std::atomic<bool> cancelled = true;
    const StrokeSet stroke = lineAt(0.0, 0.04, -0.1, 0.1);
    const Result<TriangleMesh> moved =
        attractedNear(sheet(), stroke, stroke.allPoints(), std::nullopt, {}, JobControl(&cancelled, {}));
    QVERIFY(!moved.ok());
    QVERIFY(moved.error().isCancelled());
}

QTEST_GUILESS_MAIN(LocalAttractionTest)
#include "local_attraction_test.moc"
