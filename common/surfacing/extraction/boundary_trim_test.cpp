#include "surfacing/extraction/boundary_trim.h"

#include "support/mesh_zoo.h"

#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

constexpr int cells = 30;
const Vec3 centre(0.52, 0.49, 0.0);

Stroke circle(double radius, StrokeRole role)
{
    Stroke stroke;
    stroke.role = role;
    for (int i = 0; i <= 400; ++i) {
        const double u = 2.0 * std::numbers::pi * i / 400;
        stroke.points.push_back(centre + radius * Vec3(std::cos(u), std::sin(u), 0.0));
    }
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
        association = *associate(strokes, mesh, topology, {}, {});
    }
    Result<TriangleMesh> trim(const std::vector<char> &inPlane = {}, const JobControl &control = {}) const
    {
        return trimmed(mesh, topology, association, strokes, inPlane, {}, control);
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
    const ManifoldReport report = manifoldReport(*inside);
    QVERIFY(report.isManifold());
    QCOMPARE(report.components, 1);
    QCOMPARE(inside->vertexCount() - int(MeshTopology(*inside).edges.size()) + inside->triangleCount(),
             1); // a disk
    QVERIFY2(borderOffCircle(*inside, 0.35) < 0.6 / cells,
             qPrintable(QString::number(borderOffCircle(*inside, 0.35))));
    QVERIFY(std::abs(surfaceArea(*inside) / (std::numbers::pi * 0.35 * 0.35) - 1.0) < 0.03);
    for (int t = 0; t < inside->triangleCount(); ++t)
        QVERIFY(inside->areaVector(t).z() > 0.0);
}

void BoundaryTrimTest::unmarkedSketchKeepsWhatItsStrokesEnclose()
{
    const Scene scene({circle(0.35, StrokeRole::Surface), circle(0.12, StrokeRole::Surface)});
    const auto inside = scene.trim();
    QVERIFY(inside.ok());
    QVERIFY(manifoldReport(*inside).isManifold());
    QCOMPARE(manifoldReport(*inside).components, 1);
    // Everything a stroke lies on is there, and little beyond: the shortest way along a grid's edges around a
    // disk is anything up to the polygon whose sides have the directions of the edges.
    const std::vector<char> border = MeshTopology(*inside).borderVertices();
    for (std::size_t v = 0; v < border.size(); ++v)
        if (border[v])
            QVERIFY((inside->vertices[v] - centre).norm() > 0.35 - 1.0 / cells);
    QVERIFY(surfaceArea(*inside) > std::numbers::pi * 0.35 * 0.35 * 0.99);
    QVERIFY2(surfaceArea(*inside) < 0.59, qPrintable(QString::number(surfaceArea(*inside))));
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
    QVERIFY(result->vertices == ball.vertices);
    QVERIFY(result->triangles == ball.triangles);
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
    QVERIFY(std::abs(surfaceArea(*inside) / (0.5 * std::numbers::pi * 0.35 * 0.35) - 1.0) < 0.06);
    double length = 0.0; // of the border that lies in the plane
    for (const MeshEdge &e : MeshTopology(*inside).edges)
        if (e.faceCount == 1 && inside->vertices[e.v0].x() == 0.0 && inside->vertices[e.v1].x() == 0.0)
            length += (inside->vertices[e.v0] - inside->vertices[e.v1]).norm();
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
