#include "surfacing/segmentation/data_costs.h"

#include <QtTest>

using namespace ductus;

namespace {

ImplicitPolynomial planeZ()
{
    ImplicitPolynomial plane{1, Vec3::Zero(), Eigen::VectorXd::Zero(4)};
    plane.theta[3] = 7.0; // not of unit length: Taubin's distance divides by the gradient
    return plane;
}

// Three points at heights 0.01, 0.02 and -0.03; vertex 1 has none, vertices 0 and 2 share point 1.
Association threePoints()
{
    Association a;
    for (double z : {0.01, 0.02, -0.03})
        a.points.push_back({{0.1, 0.2, z}, Vec3::UnitZ()});
    a.pointsOfVertex = {{0, 1}, {}, {1, 2}};
    a.pairCount = 4;
    return a;
}

} // namespace

class DataCostsTest : public QObject
{
    Q_OBJECT
private slots:
    void areEquationIII2();
    void oneStrayPointIsBounded();
    void unassociatedMeshCostsNothing();
    void proxyHasASayWhereNoStrokeRuns();
    void clustersCountForAllTheirVertices();
    void pointsOfFlaggedVerticesOnceEach();
};

void DataCostsTest::areEquationIII2()
{
    const std::vector<double> costs = dataCosts(threePoints(), planeZ(), 0.01, {});
    QCOMPARE(costs.size(), std::size_t(3));
    QVERIFY(std::abs(costs[0] - (1.0 + 4.0) / 4) < 1e-12);
    QCOMPARE(costs[1], 0.0);
    QVERIFY(std::abs(costs[2] - (4.0 + 9.0) / 4) < 1e-12);
    // Twice the epsilon, a quarter of the cost.
    QVERIFY(std::abs(dataCosts(threePoints(), planeZ(), 0.02, {})[2] - (4.0 + 9.0) / 16) < 1e-12);
}

void DataCostsTest::oneStrayPointIsBounded()
{
    Association a = threePoints();
    a.points[2].point.z() = 1e6;
    const double cost = dataCosts(a, planeZ(), 0.01, {})[2];
    QVERIFY(cost <= (1.0 + 0.02 * 0.02) / (0.01 * 0.01 * 4) * (1 + 1e-12)); // a whole box diagonal
    QVERIFY(cost > 100.0);
    ImplicitPolynomial nothing = planeZ(); // no gradient anywhere: neither infinite nor NaN
    nothing.theta << 1, 0, 0, 0;
    for (double c : dataCosts(a, nothing, 0.01, {}))
        QVERIFY(std::isfinite(c) && c >= 0.0);
}

void DataCostsTest::unassociatedMeshCostsNothing()
{
    Association a;
    a.pointsOfVertex.resize(5);
    QCOMPARE(dataCosts(a, planeZ(), 0.01, {}), std::vector<double>(5, 0.0));
}

void DataCostsTest::proxyHasASayWhereNoStrokeRuns()
{
    Association a = threePoints();
    a.vertices = {
        {{0, 0, 9}, Vec3::UnitX()}, {{0, 0, 0.04}, Vec3(0.5, 0, 1).normalized()}, {{0, 0, 9}, Vec3::UnitX()}};
    const auto add = [&](const Vec3 &point, const Vec3 &normal) {
        a.vertices.push_back({point, normal});
        a.pointsOfVertex.emplace_back();
    };
    add({0.2, 0, 0.1}, Vec3::UnitZ()); // twice as far as proxies stray
    add({0.2, 0, 0.9}, Vec3::UnitZ()); // a whole world away: bounded
    add({0.2, 0, 0.0}, Vec3::UnitX()); // the model runs across the proxy
    const ProxyPrior prior;
    const std::vector<double> costs = dataCosts(a, planeZ(), 0.01, prior);
    QVERIFY(std::abs(costs[0] - (1.0 + 4.0) / 4) < 1e-12); // where strokes run only they count
    QCOMPARE(costs[1], 0.0);                               // as a crude proxy may be
    QVERIFY(std::abs(costs[3] - prior.weight / 4 * 3.0) < 1e-12);
    QVERIFY(std::abs(costs[4] - prior.weight / 4 * prior.bound) < 1e-12);
    QVERIFY(std::abs(costs[5] - prior.weight / 4 * 1.0) < 1e-12);
}

void DataCostsTest::clustersCountForAllTheirVertices()
{
    Association a = threePoints();
    a.vertices = {{}, {{0, 0, 0.1}, Vec3::UnitZ()}, {}, {{0.5, 0, 0.0}, Vec3::UnitZ()}};
    a.pointsOfVertex.emplace_back();
    a.vertexCounts = {1, 30, 1, 10};
    QVERIFY(std::abs(dataCosts(a, planeZ(), 0.01, {})[1] - ProxyPrior().weight * 0.75 * 3.0) < 1e-12);
}

void DataCostsTest::pointsOfFlaggedVerticesOnceEach()
{
    const Association a = threePoints();
    QCOMPARE(pointsOf(a, {1, 0, 1}), (std::vector<int>{0, 1, 2}));
    QCOMPARE(pointsOf(a, {0, 1, 1}), (std::vector<int>{1, 2}));
    QVERIFY(pointsOf(a, {0, 1, 0}).empty());
}

QTEST_APPLESS_MAIN(DataCostsTest)
#include "data_costs_test.moc"
