#include "surfacing/segmentation/proposals.h"

#include "support/mesh_zoo.h"
#include "surfacing/segmentation/data_costs.h"

#include <QtTest>

using namespace ductus;

namespace {

// A flat square in three vertical stripes, labels 0, 1, 2; one stroke point a vertex, bent differently in
// each stripe. The border 0|1 is crossed by strokes, 1|2 is not.
struct Stripes
{
    TriangleMesh mesh = zoo::grid(12);
    MeshTopology topology{mesh};
    std::vector<int> labels;
    Association association;
    std::vector<ImplicitPolynomial> models;
    SegmentationOptions options;

    Stripes()
    {
        for (const Vec3 &p : mesh.vertices) {
            labels.push_back(p.x() < 0.3 ? 0 : p.x() < 0.7 ? 1 : 2);
            const double z = 0.1 * labels.back() * p.y() * p.y() + 0.05 * p.x();
            association.pointsOfVertex.push_back({int(association.points.size())});
            association.points.push_back({{p.x(), p.y(), z}, Vec3::UnitZ()});
        }
        association.pairCount = int(association.points.size());
        for (const MeshEdge &e : topology.edges) {
            const bool isCrossed = std::min(labels[e.v0], labels[e.v1]) == 0 && labels[e.v0] != labels[e.v1];
            association.edgeIsCrossed.push_back(isCrossed);
            association.edgeWeights.push_back(isCrossed ? 1.0 : 100.0);
        }
        for (int degree : {3, 1, 2})
            models.push_back(fit({int(models.size())}, degree));
    }

    ImplicitPolynomial fit(const std::vector<int> &regions, int degree) const
    {
        std::vector<char> flags;
        for (int label : labels)
            flags.push_back(std::count(regions.begin(), regions.end(), label) > 0);
        return fitPolynomial(association.points, pointsOf(association, flags), degree, options.fit);
    }
};

bool contains(const std::vector<ImplicitPolynomial> &models, const ImplicitPolynomial &wanted)
{
    return std::any_of(models.begin(), models.end(), [&](const ImplicitPolynomial &m) {
        return m.degree == wanted.degree && m.origin == wanted.origin && m.theta == wanted.theta;
    });
}

// Of some degree.
bool containsUnion(const Stripes &s, const std::vector<ImplicitPolynomial> &models,
                   const std::vector<int> &regions)
{
    for (int degree = 1; degree <= maxPolynomialDegree; ++degree)
        if (contains(models, s.fit(regions, degree)))
            return true;
    return false;
}

} // namespace

class ProposalsTest : public QObject
{
    Q_OBJECT
private slots:
    void regionsWithLowerDegrees();
    void mergesAcrossTheHeaviestBorderFirst();
    void triesEachMergeOnce();
    void distantRegionsAreNotMerged();
    void noMergesWhenNoneAreAsked();
    void planeForAFaceWhoseModelOnlyPassesItsOutline();
};

void ProposalsTest::regionsWithLowerDegrees()
{
    const Stripes s;
    TriedMerges tried;
    const auto proposed = proposeModels(s.association, s.topology, s.labels, s.models, s.options, tried);
    QVERIFY(contains(proposed, s.fit({0}, 2)));
    QVERIFY(contains(proposed, s.fit({2}, 1)));
    QVERIFY(!contains(proposed, s.fit({0}, 3))); // what it is already
    for (const ImplicitPolynomial &m : proposed)
        QVERIFY(m.degree >= 1 && m.degree <= s.options.maxDegree);
}

void ProposalsTest::mergesAcrossTheHeaviestBorderFirst()
{
    Stripes s;
    s.options.mergesPerIteration = 1;
    TriedMerges tried;
    const auto proposed = proposeModels(s.association, s.topology, s.labels, s.models, s.options, tried);
    QVERIFY(contains(proposed, s.fit({1, 2}, 2))); // the higher of both degrees
    QVERIFY(!containsUnion(s, proposed, {0, 1}));
}

void ProposalsTest::triesEachMergeOnce()
{
    Stripes s;
    s.options.mergesPerIteration = 1;
    TriedMerges tried;
    (void)proposeModels(s.association, s.topology, s.labels, s.models, s.options, tried);
    const auto second = proposeModels(s.association, s.topology, s.labels, s.models, s.options, tried);
    QVERIFY(containsUnion(s, second, {0, 1}));
    QVERIFY(!containsUnion(s, second, {1, 2}));
    const auto third = proposeModels(s.association, s.topology, s.labels, s.models, s.options, tried);
    QVERIFY(!containsUnion(s, third, {0, 1}));
    QVERIFY(!containsUnion(s, third, {1, 2}));
}

void ProposalsTest::distantRegionsAreNotMerged()
{
    const Stripes s;
    TriedMerges tried;
    const auto proposed = proposeModels(s.association, s.topology, s.labels, s.models, s.options, tried);
    QVERIFY(!containsUnion(s, proposed, {0, 2}));
    QVERIFY(!containsUnion(s, proposed, {0, 1, 2}));
}

void ProposalsTest::noMergesWhenNoneAreAsked()
{
    Stripes s;
    s.options.mergesPerIteration = 0;
    TriedMerges tried;
    const auto proposed = proposeModels(s.association, s.topology, s.labels, s.models, s.options, tried);
    for (const std::vector<int> &regions : {std::vector<int>{0, 1}, {1, 2}, {0, 2}})
        QVERIFY(!containsUnion(s, proposed, regions));
    for (int degree = 1; degree <= maxPolynomialDegree; ++degree)
        QVERIFY(!contains(proposed, s.fit({1}, degree))); // a plane has no lower degree
}

void ProposalsTest::planeForAFaceWhoseModelOnlyPassesItsOutline()
{
    // A flat square with strokes along its border only, explained by a cylinder that stands on it.
    Stripes s;
    s.options.mergesPerIteration = 0;
    s.association = Association();
    for (const Vec3 &p : s.mesh.vertices) {
        const bool isRim = std::min({p.x(), 1.0 - p.x(), p.y(), 1.0 - p.y()}) < 1e-9;
        s.association.vertices.push_back({p, Vec3::UnitZ()});
        s.association.pointsOfVertex.emplace_back();
        if (!isRim)
            continue;
        s.association.pointsOfVertex.back().push_back(int(s.association.points.size()));
        s.association.points.push_back({p, Vec3::UnitZ()});
    }
    s.association.pairCount = int(s.association.points.size());
    s.association.edgeIsCrossed.assign(s.topology.edges.size(), 0);
    s.association.edgeWeights.assign(s.topology.edges.size(), 1.0);
    s.labels.assign(s.mesh.vertices.size(), 0);
    ImplicitPolynomial cylinder{2, Vec3(0.5, 0.5, 0.0), Eigen::VectorXd::Zero(10)};
    cylinder.theta[0] = -0.25;
    cylinder.theta[4] = cylinder.theta[7] = 1.0;
    TriedMerges tried;
    const auto proposed = proposeModels(s.association, s.topology, s.labels, {cylinder}, s.options, tried);
    QVERIFY(std::any_of(proposed.begin(), proposed.end(), [](const ImplicitPolynomial &m) {
        Vec3 normal;
        return std::abs(m.signedDistance(Vec3(0.5, 0.5, 0.0), &normal)) < 1e-6 && normal.z() > 0.999;
    }));
    // With the plane in place nothing contradicts it any more.
    const auto again = proposeModels(s.association, s.topology, s.labels, {s.fit({0}, 1)}, s.options, tried);
    QVERIFY(again.empty());
}

QTEST_APPLESS_MAIN(ProposalsTest)
#include "proposals_test.moc"
