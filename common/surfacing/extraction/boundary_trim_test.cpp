#include "surfacing/extraction/boundary_trim.h"

#include "support/mesh_zoo.h"

#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

constexpr int cells = 30;
const Vec3 centre(0.52, 0.49, 0.0);

Stroke arc(double radius, double from, double to, StrokeRole role = StrokeRole::Surface)
{
    Stroke stroke;
    stroke.role = role;
    for (int i = 0; i <= 400; ++i) {
        const double u = from + (to - from) * i / 400;
        stroke.points.push_back(centre + radius * Vec3(std::cos(u), std::sin(u), 0.0));
    }
    return stroke;
}

Stroke circle(double radius, StrokeRole role)
{
    return arc(radius, 0.0, 2.0 * std::numbers::pi, role);
}

Stroke ray(double angle, double from, double to)
{
    Stroke stroke;
    for (int i = 0; i <= 100; ++i)
        stroke.points.push_back(centre +
                                (from + (to - from) * i / 100) * Vec3(std::cos(angle), std::sin(angle), 0.0));
    return stroke;
}

// A flat square proxy with strokes on it.
struct Scene
{
    TriangleMesh mesh = zoo::grid(cells);
    MeshTopology topology{mesh};
    StrokeSet strokes;
    Association association;

    explicit Scene(std::vector<Stroke> drawn, const TriangleMesh &proxy = zoo::grid(cells))
        : mesh(proxy), topology(proxy)
    {
        strokes.strokes = std::move(drawn);
        for (std::size_t s = 0; s < strokes.strokes.size(); ++s)
            strokes.strokes[s].id.value = int(s);
        association = *associate(strokes, mesh, topology, {}, {});
    }
    Result<TrimmedProxy> trim(const std::vector<char> &inPlane = {}, const JobControl &control = {}) const
    {
        BoundaryTrimOptions options;
        options.borderStrokes.reach *= std::sqrt(2.0); // the grid is 1 wide, not its diagonal
        return trimmed(mesh, topology, association, strokes, inPlane, options, control);
    }
};

// Distance of the border's vertices from a circle about the centre.
double borderOffCircle(const TriangleMesh &mesh, double radius)
{
    const std::vector<char> border = MeshTopology(mesh).borderVertices();
    double worst = 0.0;
    for (std::size_t v = 0; v < border.size(); ++v)
        if (border[v])
            worst = std::max(worst, std::abs((mesh.vertices[v] - centre).norm() - radius));
    return worst;
}

} // namespace

class BoundaryTrimTest : public QObject
{
    Q_OBJECT
private slots:
    void cutsAlongTheBoundaryStroke();
    void unmarkedSketchKeepsWhatItsStrokesEnclose();
    void unmarkedSketchEndsAtItsOutline();
    void unmarkedSketchEndsAtItsOutlineThoughStrokesStickOut();
    void closedProxyIsUnchanged();
    void bordersInTheSymmetryPlaneAreKept();
    void nothingInsideIsRefused();
    void cancelled();
    void cutPositionsAreWhereStrokesCross();
    void cutPositionsAreTheMeanOfSeveralStrokes();
};

void BoundaryTrimTest::cutsAlongTheBoundaryStroke()
{
    const Scene scene({circle(0.35, StrokeRole::Boundary), circle(0.12, StrokeRole::Surface)});
    const auto inside = scene.trim();
    QVERIFY(inside.ok());
    const ManifoldReport report = manifoldReport(inside->mesh);
    QVERIFY(report.isManifold());
    QCOMPARE(report.components, 1);
    QCOMPARE(inside->mesh.vertexCount() - int(MeshTopology(inside->mesh).edges.size()) +
                 inside->mesh.triangleCount(),
             1); // a disk
    QVERIFY2(borderOffCircle(inside->mesh, 0.35) < 0.6 / cells,
             qPrintable(QString::number(borderOffCircle(inside->mesh, 0.35))));
    QVERIFY(std::abs(surfaceArea(inside->mesh) / (std::numbers::pi * 0.35 * 0.35) - 1.0) < 0.03);
    for (int t = 0; t < inside->mesh.triangleCount(); ++t)
        QVERIFY(inside->mesh.areaVector(t).z() > 0.0);
}

void BoundaryTrimTest::unmarkedSketchKeepsWhatItsStrokesEnclose()
{
    // Nothing outlines these: rays from the middle.
    std::vector<Stroke> rays;
    for (int k = 0; k < 12; ++k)
        rays.push_back(ray(std::numbers::pi * k / 6, 0.05, 0.35));
    const Scene scene(rays);
    const auto inside = scene.trim();
    QVERIFY(inside.ok());
    QVERIFY(manifoldReport(inside->mesh).isManifold());
    QCOMPARE(manifoldReport(inside->mesh).components, 1);
    QVERIFY(inside->borderStrokes.strokes.empty());
    // Everything a stroke lies on is there, and little beyond: the shortest way along a grid's edges around a
    // disk is anything up to the polygon whose sides have the directions of the edges.
    QVERIFY(surfaceArea(inside->mesh) > std::numbers::pi * 0.35 * 0.35 * 0.9);
    QVERIFY2(surfaceArea(inside->mesh) < 0.59, qPrintable(QString::number(surfaceArea(inside->mesh))));
}

void BoundaryTrimTest::unmarkedSketchEndsAtItsOutline()
{
    // The outline in three strokes with gaps, strokes across it that end a little too far, a rivet beside it.
    std::vector<Stroke> strokes{arc(0.35, 0.1, 2.0), arc(0.35, 2.1, 4.1), arc(0.35, 4.2, 6.3),
                                circle(0.15, StrokeRole::Surface)};
    for (int k = 0; k < 8; ++k)
        strokes.push_back(ray(std::numbers::pi * k / 4, 0.02, 0.37 + 0.004 * k));
    Stroke rivet = circle(0.02, StrokeRole::Surface);
    for (Vec3 &p : rivet.points)
        p.x() += 0.3;
    strokes.push_back(rivet);
    const Scene scene(strokes);
    const auto inside = scene.trim();
    QVERIFY(inside.ok());
    QVERIFY(manifoldReport(inside->mesh).isManifold());
    std::vector<int> border;
    for (const Stroke &stroke : inside->borderStrokes.strokes)
        border.push_back(stroke.id.value);
    QCOMPARE(border, (std::vector<int>{0, 1, 2}));
    QVERIFY2(borderOffCircle(inside->mesh, 0.35) < 1.0 / cells,
             qPrintable(QString::number(borderOffCircle(inside->mesh, 0.35))));
    QVERIFY(std::abs(surfaceArea(inside->mesh) / (std::numbers::pi * 0.35 * 0.35) - 1.0) < 0.03);
}

void BoundaryTrimTest::unmarkedSketchEndsAtItsOutlineThoughStrokesStickOut()
{
    // As a mouse's sides beyond its rim: the first cut spans from one end to the next, off the outline.
    std::vector<Stroke> strokes{arc(0.35, 0.1, 2.0), arc(0.35, 2.1, 4.1), arc(0.35, 4.2, 6.3)};
    for (int k = 0; k < 10; ++k)
        strokes.push_back(ray(std::numbers::pi * k / 5, 0.25, 0.39));
    const Scene scene(strokes, zoo::grid(3 * cells));
    const auto inside = scene.trim();
    QVERIFY(inside.ok());
    std::vector<int> border;
    for (const Stroke &stroke : inside->borderStrokes.strokes)
        border.push_back(stroke.id.value);
    QCOMPARE(border, (std::vector<int>{0, 1, 2}));
    QVERIFY2(borderOffCircle(inside->mesh, 0.35) < 1.0 / cells,
             qPrintable(QString::number(borderOffCircle(inside->mesh, 0.35))));
}

void BoundaryTrimTest::closedProxyIsUnchanged()
{
    TriangleMesh ball = zoo::icosphere(3);
    Stroke stroke;
    for (int i = 0; i <= 100; ++i)
        stroke.points.push_back({std::cos(0.06 * i), std::sin(0.06 * i), 0.0});
    stroke.role = StrokeRole::Boundary;
    const Scene scene({stroke}, ball);
    const auto result = scene.trim();
    QVERIFY(result.ok());
    QVERIFY(result->mesh.vertices == ball.vertices);
    QVERIFY(result->mesh.triangles == ball.triangles);
}

void BoundaryTrimTest::bordersInTheSymmetryPlaneAreKept()
{
    // Half a disk about the middle of the side x = 0, which lies in the mirror plane.
    std::vector<Stroke> strokes;
    for (double radius : {0.35, 0.1}) {
        Stroke arc;
        arc.role = radius > 0.2 ? StrokeRole::Boundary : StrokeRole::Surface;
        for (int i = 0; i <= 200; ++i) {
            const double u = std::numbers::pi * (i / 200.0 - 0.5);
            arc.points.push_back({radius * std::cos(u) + 1e-3, 0.5 + radius * std::sin(u), 0.0});
        }
        strokes.push_back(arc);
    }
    const Scene scene(strokes);
    std::vector<char> inPlane;
    for (const Vec3 &p : scene.mesh.vertices)
        inPlane.push_back(p.x() == 0.0);
    const auto inside = scene.trim(inPlane);
    QVERIFY(inside.ok());
    QVERIFY(std::abs(surfaceArea(inside->mesh) / (0.5 * std::numbers::pi * 0.35 * 0.35) - 1.0) < 0.06);
    double length = 0.0; // of the border that lies in the plane
    for (const MeshEdge &e : MeshTopology(inside->mesh).edges)
        if (e.faceCount == 1 && inside->mesh.vertices[e.v0].x() == 0.0 &&
            inside->mesh.vertices[e.v1].x() == 0.0)
            length += (inside->mesh.vertices[e.v0] - inside->mesh.vertices[e.v1]).norm();
    QVERIFY2(std::abs(length - 0.7) < 2.0 / cells, qPrintable(QString::number(length)));
}

void BoundaryTrimTest::nothingInsideIsRefused()
{
    const Scene scene({circle(0.03, StrokeRole::Boundary)});
    const auto result = scene.trim();
    QVERIFY(!result.ok());
    QCOMPARE(result.error().code, ErrorCode::NoSolution);
    QVERIFY(!result.error().remedy.empty());
}

void BoundaryTrimTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    const Scene scene({circle(0.35, StrokeRole::Boundary), circle(0.12, StrokeRole::Surface)});
    const auto result = scene.trim({}, JobControl(&cancel, {}));
    QVERIFY(!result.ok());
    QVERIFY(result.error().isCancelled());
}

void BoundaryTrimTest::cutPositionsAreWhereStrokesCross()
{
    Stroke stroke;
    for (int i = 0; i <= 2000; ++i)
        stroke.points.push_back({0.413, 0.02 + 0.96 * i / 2000.0, 0.0});
    const Scene scene({stroke});
    const std::vector<double> positions = strokeCutPositions(scene.mesh, scene.topology, scene.association);
    QCOMPARE(positions.size(), scene.topology.edges.size());
    int crossed = 0;
    for (std::size_t e = 0; e < positions.size(); ++e) {
        if (!scene.association.edgeIsCrossed[e]) {
            QCOMPARE(positions[e], 0.5);
            continue;
        }
        ++crossed;
        const Vec3 a = scene.mesh.vertices[scene.topology.edges[e].v0],
                   b = scene.mesh.vertices[scene.topology.edges[e].v1];
        QVERIFY(std::abs((a + positions[e] * (b - a)).x() - 0.413) < 1e-3);
    }
    QVERIFY(crossed > 50);
}

void BoundaryTrimTest::cutPositionsAreTheMeanOfSeveralStrokes()
{
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const MeshTopology topology(mesh);
    Association association;
    const int edge = topology.edgeBetween(0, 1);
    for (double x : {0.1, 0.3, 5.0, -2.0}) { // those beyond the ends count as the ends
        association.points.push_back({{x, 0.2, 0.1}, Vec3::UnitZ()});
        association.samples.push_back({0, edge});
    }
    const std::vector<double> positions = strokeCutPositions(mesh, topology, association);
    QVERIFY(std::abs(positions[edge] - (0.1 + 0.3 + 1.0 + 0.0) / 4) < 1e-14);
    QCOMPARE(positions[topology.edgeBetween(1, 2)], 0.5);
}

QTEST_APPLESS_MAIN(BoundaryTrimTest)
#include "boundary_trim_test.moc"
