#include "surfacing/proxy/least_squares_mesh.h"

#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "support/mesh_zoo.h"

#include <Eigen/Dense>
#include <QtTest>

using namespace ductus;

namespace {

TriangleMesh ball(int level, double radius)
{
    TriangleMesh mesh = zoo::icosphere(level);
    for (Vec3 &p : mesh.vertices)
        p *= radius;
    return mesh;
}

std::vector<Vec3> circle(double radius, double z = 0.0)
{
    std::vector<Vec3> points;
    for (int i = 0; i < 120; ++i) {
        const double u = 2.0 * std::numbers::pi * (i + 0.3) / 120;
        points.push_back({radius * std::cos(u), radius * std::sin(u), z});
    }
    return points;
}

TriangleMesh pulled(const TriangleMesh &mesh, const std::vector<Vec3> &points,
                    const AttractionOptions &options = {})
{
    Result<TriangleMesh> result = attracted(mesh, points, options, {});
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return std::move(*result);
}

double worstMove(const TriangleMesh &a, const TriangleMesh &b)
{
    double worst = 0.0;
    for (std::size_t v = 0; v < a.vertices.size(); ++v)
        worst = std::max(worst, (a.vertices[v] - b.vertices[v]).norm());
    return worst;
}

} // namespace

class LeastSquaresMeshTest : public QObject
{
    Q_OBJECT
private slots:
    void strokesPullTheSurfaceToThem();
    void oneRoundSolvesItsDefinition_data();
    void oneRoundSolvesItsDefinition();
    void farStrokesDoNotPull();
    void bordersStay();
    void connectivityIsKept();
    void cancelled();
};

void LeastSquaresMeshTest::strokesPullTheSurfaceToThem()
{
    const TriangleMesh proxy = ball(4, 0.4);
    std::vector<Vec3> strokes = circle(0.425);
    for (std::size_t i = 0; i < 120; ++i) // and around the other two axes
        for (int turns : {1, 2})
            strokes.push_back({strokes[i][turns], strokes[i][(turns + 1) % 3], strokes[i][(turns + 2) % 3]});
    const TriangleMesh result = pulled(proxy, strokes);
    const NearestOnMesh before(proxy), after(result);
    for (const Vec3 &p : strokes) {
        QVERIFY(before.nearest(p).distance > 0.02);
        QVERIFY2(after.nearest(p).distance < 2e-3, qPrintable(QString::number(after.nearest(p).distance)));
    }
    QVERIFY(manifoldReport(result).isClosed());
    // What the strokes leave open stays round enough to be a proxy.
    QVERIFY2(signedVolume(result) > 0.8 * signedVolume(proxy),
             qPrintable(QString::number(signedVolume(result) / signedVolume(proxy))));
    QVERIFY(signedVolume(result) < 1.25 * signedVolume(proxy));
}

void LeastSquaresMeshTest::oneRoundSolvesItsDefinition_data()
{
    QTest::addColumn<bool>("isOpen");
    QTest::newRow("closed") << false;
    QTest::newRow("with a border") << true;
}

// The minimiser of the sum of squares in the header, dense.
void LeastSquaresMeshTest::oneRoundSolvesItsDefinition()
{
    QFETCH(bool, isOpen);
    const TriangleMesh proxy = isOpen ? zoo::grid(7, 0.1) : ball(1, 0.4);
    std::vector<Vec3> points = isOpen
                                   ? std::vector<Vec3>{{0.3, 0.3, 0.1}, {0.6, 0.55, 0.07}, {0.31, 0.72, 0.05}}
                                   : circle(0.41, 0.02);
    AttractionOptions options;
    options.rounds = 1;
    options.maxDistance = 0.1;
    const int n = proxy.vertexCount();
    const MeshTopology topology(proxy);
    const std::vector<char> border = topology.borderVertices();
    const NearestOnMesh nearest(proxy);
    std::vector<Eigen::RowVectorXd> rows;
    std::vector<Vec3> targets;
    for (int v = 0; v < n; ++v) {
        Eigen::RowVectorXd laplacian = Eigen::RowVectorXd::Zero(n);
        std::vector<int> around;
        for (int e : topology.vertexEdges[v])
            if (!border[v] || topology.isBorder(e))
                around.push_back(topology.neighbour(v, e));
        laplacian[v] = 1.0;
        for (int u : around)
            laplacian[u] -= 1.0 / double(around.size());
        rows.push_back(laplacian);
        targets.push_back(Vec3::Zero());
        const double anchor = std::sqrt(border[v] ? options.borderAnchorWeight : options.anchorWeight);
        rows.push_back(anchor * Eigen::RowVectorXd::Unit(n, v));
        targets.push_back(anchor * proxy.vertices[v]);
    }
    for (const Vec3 &p : points) {
        const NearestPoint foot = nearest.nearest(p);
        QVERIFY(foot.distance < options.maxDistance);
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(n);
        for (int k = 0; k < 3; ++k)
            row[proxy.triangles[foot.triangle][k]] = std::sqrt(options.controlWeight) * foot.barycentric[k];
        rows.push_back(row);
        targets.push_back(std::sqrt(options.controlWeight) * p);
    }
    Eigen::MatrixXd A(Eigen::Index(rows.size()), n), b(Eigen::Index(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        A.row(Eigen::Index(i)) = rows[i];
        b.row(Eigen::Index(i)) = targets[i].transpose();
    }
    const Eigen::MatrixXd x = A.colPivHouseholderQr().solve(b);
    const TriangleMesh result = pulled(proxy, points, options);
    for (int v = 0; v < n; ++v)
        QVERIFY2((result.vertices[v].transpose() - x.row(v)).norm() < 1e-8, qPrintable(QString::number(v)));
}

void LeastSquaresMeshTest::farStrokesDoNotPull()
{
    const TriangleMesh proxy = ball(3, 0.4);
    std::vector<Vec3> strokes = circle(0.41);
    const TriangleMesh near = pulled(proxy, strokes);
    const std::vector<Vec3> far = circle(0.5), inside = circle(0.2, 0.1);
    strokes.insert(strokes.end(), far.begin(), far.end());
    strokes.insert(strokes.end(), inside.begin(), inside.end());
    QVERIFY(worstMove(near, pulled(proxy, strokes)) == 0.0);
    AttractionOptions wide;
    wide.maxDistance = 0.2;
    QVERIFY(worstMove(near, pulled(proxy, strokes, wide)) > 0.01);
}

void LeastSquaresMeshTest::bordersStay()
{
    const TriangleMesh sheet = zoo::grid(20);
    std::vector<Vec3> line;
    for (int i = 0; i <= 50; ++i)
        line.push_back({0.2 + 0.6 * i / 50.0, 0.5, 0.02});
    const TriangleMesh result = pulled(sheet, line);
    const std::vector<char> border = MeshTopology(sheet).borderVertices();
    double worst = 0.0;
    for (std::size_t v = 0; v < border.size(); ++v) {
        const Vec3 &p = sheet.vertices[v];
        const bool isCorner = (p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1);
        if (border[v] && !isCorner)
            worst = std::max(worst, (result.vertices[v] - p).norm());
    }
    QVERIFY2(worst < 0.03, qPrintable(QString::number(worst)));
    QVERIFY(NearestOnMesh(result).nearest({0.5, 0.5, 0.02}).distance < 2e-3);
}

void LeastSquaresMeshTest::connectivityIsKept()
{
    const TriangleMesh proxy = zoo::torus();
    const TriangleMesh result = pulled(proxy, circle(1.36));
    QVERIFY(result.triangles == proxy.triangles);
    QCOMPARE(result.vertexCount(), proxy.vertexCount());
    QVERIFY(pulled(proxy, circle(1.36)).vertices == result.vertices);
}

void LeastSquaresMeshTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    const auto result = attracted(zoo::torus(), circle(1.36), {}, JobControl(&cancel, {}));
    QVERIFY(!result.ok());
    QVERIFY(result.error().isCancelled());
}

QTEST_APPLESS_MAIN(LeastSquaresMeshTest)
#include "least_squares_mesh_test.moc"
