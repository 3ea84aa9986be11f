#include "support/solids.h"

#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "support/segment_index.h"
#include "support/solid_builder.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace ductus;

class SolidsTest : public QObject
{
    Q_OBJECT
private slots:
    void isAManifold_data() { addSolids(); }
    void isAManifold();
    void facesAreSmoothAndConnected_data() { addSolids(); }
    void facesAreSmoothAndConnected();
    void curvesLieOnTheSurface_data() { addSolids(); }
    void curvesLieOnTheSurface();
    void everySharpEdgeBelongsToASharpCurve_data() { addSolids(); }
    void everySharpEdgeBelongsToASharpCurve();
    void mirrorImageIsTheSame_data() { addSolids(); }
    void mirrorImageIsTheSame();
    void volumesAreKnown();
    void measuresAreParameters();
    void splineRunsThroughItsKnotsEvenly();
    void coonsPatchKeepsItsBorders();

private:
    static void addSolids()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < allSolids().size(); ++i)
            QTest::newRow(allSolids()[i].id.c_str()) << int(i);
    }
    static Solid make(int index)
    {
        const SolidEntry &entry = allSolids()[std::size_t(index)];
        Solid solid = entry.make();
        return solid.id == entry.id ? solid : Solid();
    }
};

void SolidsTest::isAManifold()
{
    QFETCH(int, index);
    const Solid solid = make(index);
    QVERIFY(solid.mesh.triangleCount() > 500);
    QCOMPARE(int(solid.triangleFaces.size()), solid.mesh.triangleCount());
    const ManifoldReport report = manifoldReport(solid.mesh);
    QVERIFY(report.isManifold());
    QCOMPARE(report.degenerateTriangles, 0);
    QCOMPARE(report.components, 1);
    QCOMPARE(report.isClosed(), !solid.isOpen);
    const std::set<std::string> open{"saddle", "bent-leaf"}, handles{"torus", "iron"};
    QCOMPARE(solid.isOpen, open.count(solid.id) == 1);
    if (!solid.isOpen)
        QVERIFY(signedVolume(solid.mesh) > 0.0);
    const int euler =
        solid.mesh.vertexCount() - int(MeshTopology(solid.mesh).edges.size()) + solid.mesh.triangleCount();
    QCOMPARE(euler, solid.isOpen ? 1 : handles.count(solid.id) ? 0 : 2);
}

void SolidsTest::facesAreSmoothAndConnected()
{
    QFETCH(int, index);
    const Solid solid = make(index);
    const MeshTopology topology(solid.mesh);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const MeshEdge &edge = topology.edges[e];
        if (edge.faceCount == 2 && solid.triangleFaces[edge.faces[0]] == solid.triangleFaces[edge.faces[1]]) {
            const double angle = dihedralDegrees(solid.mesh, topology, int(e));
            QVERIFY2(angle < 15.0, (solid.faceNames[solid.triangleFaces[edge.faces[0]]] +
                                    " has a crease of " + std::to_string(angle))
                                       .c_str());
        }
    }
    for (int face = 0; face < solid.faceCount(); ++face) {
        TriangleMesh part;
        part.vertices = solid.mesh.vertices;
        for (int t = 0; t < solid.mesh.triangleCount(); ++t)
            if (solid.triangleFaces[t] == face)
                part.triangles.push_back(solid.mesh.triangles[t]);
        QVERIFY2(!part.triangles.empty(), solid.faceNames[face].c_str());
        QCOMPARE(manifoldReport(compacted(part)).components, 1);
    }
}

void SolidsTest::curvesLieOnTheSurface()
{
    QFETCH(int, index);
    const Solid solid = make(index);
    const NearestOnMesh nearest(solid.mesh);
    const double diagonal = solid.diagonal();
    int flow = 0, boundary = 0;
    for (const FeatureCurve &curve : solid.curves) {
        QVERIFY2(curve.points.size() >= 4, curve.name.c_str());
        QCOMPARE(curve.sharp.size(), curve.points.size());
        for (const Vec3 &point : curve.points)
            QVERIFY2(nearest.nearest(point).distance < 5e-4 * diagonal, curve.name.c_str());
        flow += curve.kind == CurveKind::Flow;
        boundary += curve.kind == CurveKind::Boundary;
        if (curve.kind == CurveKind::Boundary)
            QCOMPARE(std::count(curve.sharp.begin(), curve.sharp.end(), 1), std::ptrdiff_t(0));
    }
    QVERIFY(flow > 0 || solid.id == "l-bracket");
    QCOMPARE(boundary > 0, solid.isOpen);
}

void SolidsTest::everySharpEdgeBelongsToASharpCurve()
{
    QFETCH(int, index);
    const Solid solid = make(index);
    std::vector<Segment> sharp;
    for (const FeatureCurve &curve : solid.curves)
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
            if (curve.sharp[i] && curve.sharp[i + 1])
                sharp.push_back({curve.points[i], curve.points[i + 1]});
    const std::set<std::string> smooth{"torus", "ellipsoid", "saddle"};
    QCOMPARE(sharp.empty(), smooth.count(solid.id) == 1);
    const double tolerance = 1e-4 * solid.diagonal();
    const SegmentIndex index2(sharp, tolerance);
    const MeshTopology topology(solid.mesh);
    double drawn = 0.0, all = 0.0;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        if (dihedralDegrees(solid.mesh, topology, int(e)) <= Solid::sharpDegrees)
            continue;
        const Vec3 &a = solid.mesh.vertices[topology.edges[e].v0],
                   &b = solid.mesh.vertices[topology.edges[e].v1];
        all += (b - a).norm();
        drawn += index2.isWithin(0.5 * (a + b), tolerance) ? (b - a).norm() : 0.0;
    }
    // Nobody draws the edges of the wheel tunnels under a car.
    QVERIFY2(drawn >= (solid.id == "car-cut-arches" ? 0.7 : 0.999999) * all,
             (std::to_string(drawn) + " of " + std::to_string(all)).c_str());
}

void SolidsTest::mirrorImageIsTheSame()
{
    QFETCH(int, index);
    const Solid solid = make(index);
    QVERIFY(solid.mirror.has_value());
    const NearestOnMesh nearest(solid.mesh);
    for (const Vec3 &vertex : solid.mesh.vertices)
        QVERIFY(nearest.nearest(solid.mirror->mirrored(vertex)).distance < 1e-9);
    double off = 0.0;
    for (const Vec3 &vertex : solid.mesh.vertices)
        off = std::max(off, std::abs(solid.mirror->signedDistance(vertex)));
    QVERIFY(off > 0.05 * solid.diagonal());
}

void SolidsTest::volumesAreKnown()
{
    const auto isNear = [](double value, double expected, double share) {
        return std::abs(value - expected) < share * expected;
    };
    const double pi = std::numbers::pi;
    QVERIFY(isNear(signedVolume(torus(0.3, 0.1).mesh), 2 * pi * pi * 0.3 * 0.01, 0.01));
    QVERIFY(isNear(signedVolume(ellipsoid({0.3, 0.2, 0.1}).mesh), 4.0 / 3.0 * pi * 0.006, 0.01));
    QVERIFY(isNear(signedVolume(can(0.2, 0.5).mesh), pi * 0.04 * 0.5, 0.005));
    QVERIFY(isNear(signedVolume(lBracket(0.4, 0.1, 0.2).mesh), 0.2 * (0.04 + 0.03), 1e-9));
    QVERIFY(isNear(signedVolume(house(0.4, 0.2, 0.1, 0.5).mesh), 0.5 * (0.08 + 0.02), 1e-9));
    // Walls, and a frustum with parallel rectangles of 0.4 x 0.3 and 0.2 x 0.1 (prismatoid rule).
    const double frustum = 0.1 / 6.0 * (0.12 + 4 * 0.3 * 0.2 + 0.02);
    QVERIFY(isNear(signedVolume(bevelledBox(0.4, 0.3, 0.3, 0.1).mesh), 0.12 * 0.2 + frustum, 1e-9));
}

void SolidsTest::measuresAreParameters()
{
    const Box3 longCar = boundingBox(car({.cutArches = false, .length = 1.2, .height = 1.3}).mesh.vertices);
    const Box3 plainCar = boundingBox(car().mesh.vertices);
    QVERIFY((longCar.max - longCar.min).x() > 1.15 * (plainCar.max - plainCar.min).x());
    QVERIFY(longCar.max.y() > 1.05 * plainCar.max.y());
    QVERIFY(manifoldReport(car({.cutArches = true, .length = 0.9, .height = 1.2}).mesh).isClosed());
    // Cut arches take away four quarter-tunnels' worth of body.
    QVERIFY(signedVolume(car({.cutArches = true}).mesh) < 0.97 * signedVolume(car().mesh));
    QVERIFY(std::abs(boundingBox(bottle(0.1, 0.8).mesh.vertices).max.y() - 0.8) < 1e-9);
}

void SolidsTest::splineRunsThroughItsKnotsEvenly()
{
    const std::vector<Vec3> knots{Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(2, 0, 1), Vec3(4, 0, 0)};
    const Polyline line = splinePoints(knots, 400);
    QCOMPARE(line.size(), std::size_t(401));
    for (const Vec3 &knot : knots) {
        double nearest = 1e9;
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            nearest = std::min(nearest, distanceToSegment(knot, {line[i], line[i + 1]}));
        QVERIFY(nearest < 1e-4);
    }
    const double step = (line[1] - line[0]).norm();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        QVERIFY(std::abs((line[i + 1] - line[i]).norm() - step) < 0.02 * step);
}

void SolidsTest::coonsPatchKeepsItsBorders()
{
    const Vec3 a(0, 0, 0), b(1, 0, 0.2), c(1.1, 1, 0), d(0, 1.2, 0);
    const Polyline bottom = splinePoints({a, Vec3(0.5, 0, 0.3), b}, 10),
                   top = splinePoints({d, Vec3(0.5, 1, 0.4), c}, 10);
    const Polyline left = splinePoints({a, Vec3(-0.1, 0.5, 0.1), d}, 7), right = linePoints(b, c, 7);
    const GridPatch patch = coonsPatch(bottom, top, left, right);
    const auto same = [](const Polyline &p, const Polyline &q) {
        double worst = p.size() == q.size() ? 0.0 : 1.0;
        for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i)
            worst = std::max(worst, (p[i] - q[i]).norm());
        return worst < 1e-12;
    };
    QVERIFY(same(patch.row(0), bottom) && same(patch.row(7), top));
    QVERIFY(same(patch.column(0), left) && same(patch.column(10), right));
    QVERIFY((patch.interpolate(0.3, 0.0) - bottom[3]).norm() < 1e-12);
}

QTEST_APPLESS_MAIN(SolidsTest)
#include "solids_test.moc"
