#include "surfacing/proxy/proxy_quality.h"

#include "geometry/mesh_topology.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

TriangleMesh ball(const Vec3 &centre, double radius)
{
    TriangleMesh mesh = zoo::icosphere(3);
    for (Vec3 &p : mesh.vertices)
        p = centre + radius * p;
    return mesh;
}

// Two great circles.
std::vector<Vec3> circles(const Vec3 &centre, double radius)
{
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i) {
        const double u = 0.01 * std::numbers::pi * i;
        points.push_back(centre + radius * Vec3(std::cos(u), std::sin(u), 0));
        points.push_back(centre + radius * Vec3(0, std::cos(u), std::sin(u)));
    }
    return points;
}

const Vec3 origin = Vec3::Zero();

} // namespace

class ProxyQualityTest : public QObject
{
    Q_OBJECT
private slots:
    void goodProxyHasNoFault();
    void surfaceBesideTheStrokesIsAFault();
    void fewFarStrokesAreAFault();
    void foldsAreAFault();
    void emptyProxyIsAFault();
    void strayComponentsAreDropped();
    void componentsWithStrokesAreKept();
};

void ProxyQualityTest::goodProxyHasNoFault()
{
    QVERIFY(!proxyFault(ball(origin, 0.4), ball(origin, 0.41), circles(origin, 0.4), {}).has_value());
}

void ProxyQualityTest::surfaceBesideTheStrokesIsAFault()
{
    const auto fault = proxyFault(ball(origin, 0.37), ball(origin, 0.41), circles(origin, 0.4), {});
    QVERIFY(fault.has_value());
    QVERIFY(QString::fromStdString(*fault).contains("%"));
    ProxyQualityLimits generous;
    generous.medianDistance = 0.05;
    QVERIFY(!proxyFault(ball(origin, 0.37), ball(origin, 0.41), circles(origin, 0.4), generous).has_value());
}

void ProxyQualityTest::fewFarStrokesAreAFault()
{
    std::vector<Vec3> points = circles(origin, 0.4);
    for (std::size_t i = 0; i < points.size(); i += 10) // a tenth: the median does not see them
        points[i] *= 1.3;
    QVERIFY(proxyFault(ball(origin, 0.4), ball(origin, 0.41), points, {}).has_value());
    points = circles(origin, 0.4);
    for (std::size_t i = 0; i < points.size(); i += 50) // one in fifty is anyone's slip
        points[i] *= 1.3;
    QVERIFY(!proxyFault(ball(origin, 0.4), ball(origin, 0.41), points, {}).has_value());
}

void ProxyQualityTest::foldsAreAFault()
{
    TriangleMesh folded = ball(origin, 0.4);
    for (double radius : {0.38, 0.36, 0.34})
        folded = zoo::together(folded, ball(origin, radius));
    QVERIFY(proxyFault(folded, ball(origin, 0.41), circles(origin, 0.4), {}).has_value());
}

void ProxyQualityTest::emptyProxyIsAFault()
{
    QVERIFY(proxyFault({}, ball(origin, 0.41), circles(origin, 0.4), {}).has_value());
    QVERIFY(proxyFault(zoo::tetrahedron(), ball(origin, 0.41), circles(origin, 0.4), {}).has_value());
}

void ProxyQualityTest::strayComponentsAreDropped()
{
    const TriangleMesh both = zoo::together(ball({1, 0, 0}, 0.2), ball(origin, 0.4));
    const TriangleMesh kept = withoutStrayComponents(both, circles(origin, 0.4));
    QCOMPARE(manifoldReport(kept).components, 1);
    QCOMPARE(kept.vertexCount(), ball(origin, 0.4).vertexCount());
    for (const Vec3 &p : kept.vertices)
        QVERIFY(p.norm() < 0.41);
    QVERIFY(manifoldReport(kept).isClosed());
}

void ProxyQualityTest::componentsWithStrokesAreKept()
{
    const TriangleMesh both = zoo::together(ball({1, 0, 0}, 0.2), ball(origin, 0.4));
    std::vector<Vec3> points = circles(origin, 0.4); // 400
    const std::vector<Vec3> small = circles({1, 0, 0}, 0.2);
    points.insert(points.end(), small.begin(), small.begin() + 6); // 1.5 %
    QCOMPARE(manifoldReport(withoutStrayComponents(both, points)).components, 1);
    points.insert(points.end(), small.begin() + 6, small.begin() + 26); // 6 %
    QCOMPARE(manifoldReport(withoutStrayComponents(both, points)).components, 2);
    const TriangleMesh one = ball(origin, 0.4);
    QVERIFY(withoutStrayComponents(one, points).triangles == one.triangles);
}

QTEST_APPLESS_MAIN(ProxyQualityTest)
#include "proxy_quality_test.moc"
