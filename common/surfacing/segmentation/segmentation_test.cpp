#include "surfacing/segmentation/segmentation.h"

#include "support/mesh_zoo.h"

#include <QtTest>
#include <set>

using namespace ductus;

namespace {

constexpr double creaseX = 0.0;

// Two planes that meet at right angles along x = 0, between two columns of vertices; strokes along the
// crease, along the slopes and across both. About the unit frame.
struct Roof
{
    TriangleMesh mesh = zoo::grid(25);
    MeshTopology topology{mesh};
    Association association;

    Roof()
    {
        for (Vec3 &p : mesh.vertices)
            p = on(0.66 * (p.x() - 0.5), 0.66 * (p.y() - 0.5));
        StrokeSet strokes;
        const auto draw = [&](auto point) {
            Stroke stroke;
            for (int i = 0; i <= 80; ++i)
                stroke.points.push_back(point(-0.33 + 0.66 * i / 80.0));
            strokes.strokes.push_back(stroke);
        };
        for (double x : {-0.3, -0.17, creaseX, 0.17, 0.3})
            draw([x](double t) { return on(x, t); });
        for (double y : {-0.29, 0.01, 0.29})
            draw([y](double t) { return on(t, y); });
        association = *associate(strokes, mesh, topology, {}, {});
    }

    static Vec3 on(double x, double y) { return {x, y, 0.16 - std::abs(x - creaseX)}; }
};

const Roof &roof()
{
    static const Roof scene;
    return scene;
}

SegmentationOptions smallOptions()
{
    SegmentationOptions options;
    options.clusterCounts = {4, 8, 12};
    options.runs = 3;
    return options;
}

Result<Segmentation> segmentRoof(const SegmentationOptions &options, const JobControl &control = {})
{
    return segment(roof().association, roof().topology, options, control);
}

// Wrong by at most what rounding does to a sum.
bool isClose(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * std::max({std::abs(a), std::abs(b), 1e-6});
}

} // namespace

class SegmentationTest : public QObject
{
    Q_OBJECT
private slots:
    void aRoofIsTwoPlanes();
    void seamsRunAlongStrokes();
    void energyIsItsDefinition();
    void labelsAndModelsBelongTogether();
    void noOtherLabelOfOneVertexIsBetter();
    void sameSeedSameResult();
    void bestOfSeveralRuns();
    void simplicityDecidesTheNumberOfModels();
    void cancelledAtAnyProgress();
};

void SegmentationTest::aRoofIsTwoPlanes()
{
    const auto s = segmentRoof(smallOptions());
    QVERIFY(s.ok());
    QCOMPARE(s->models.size(), std::size_t(2));
    int labelOfSide[2] = {-1, -1};
    for (int v = 0; v < roof().mesh.vertexCount(); ++v) {
        const int side = roof().mesh.vertices[v].x() > creaseX;
        if (labelOfSide[side] < 0)
            labelOfSide[side] = s->labels[v];
        QCOMPARE(s->labels[v], labelOfSide[side]);
    }
    QVERIFY(labelOfSide[0] != labelOfSide[1]);
    for (double x : {-0.2, 0.2})
        for (double y : {-0.2, 0.0, 0.2}) {
            const ImplicitPolynomial &model = s->models[labelOfSide[x > creaseX]];
            QVERIFY(std::abs(model.signedDistance(Roof::on(x, y))) < 2e-3);
        }
}

void SegmentationTest::seamsRunAlongStrokes()
{
    const auto s = segmentRoof(smallOptions());
    QVERIFY(s.ok());
    int seamEdges = 0;
    for (std::size_t e = 0; e < roof().topology.edges.size(); ++e) {
        const MeshEdge &edge = roof().topology.edges[e];
        if (s->labels[edge.v0] == s->labels[edge.v1] || edge.faceCount != 2) // strokes end before the border
            continue;
        ++seamEdges;
        QVERIFY(roof().association.edgeIsCrossed[e]);
    }
    QVERIFY(seamEdges >= 25);
}

// Eq. III.1 to III.5, written from the thesis.
void SegmentationTest::energyIsItsDefinition()
{
    for (double epsilon : {0.01, 0.004}) {
        SegmentationOptions options = smallOptions();
        options.epsilon = epsilon;
        options.simplicity = 0.02;
        const auto s = segmentRoof(options);
        QVERIFY(s.ok());
        const Association &a = roof().association;
        double fidelity = 0.0, smoothness = 0.0, totalWeight = 0.0, simplicity = 0.0;
        int pairs = 0;
        for (std::size_t v = 0; v < a.pointsOfVertex.size(); ++v)
            for (int i : a.pointsOfVertex[v]) {
                Vec3 gradient;
                const double f = s->models[s->labels[v]].valueAndGradient(a.points[i].point, gradient);
                fidelity += f * f / gradient.squaredNorm();
                ++pairs;
            }
        fidelity /= epsilon * epsilon * pairs;
        for (std::size_t e = 0; e < a.edgeWeights.size(); ++e) {
            const MeshEdge &edge = roof().topology.edges[e];
            totalWeight += a.edgeWeights[e];
            smoothness += s->labels[edge.v0] != s->labels[edge.v1] ? a.edgeWeights[e] : 0.0;
        }
        smoothness /= totalWeight;
        for (int label : std::set<int>(s->labels.begin(), s->labels.end()))
            simplicity += s->models[label].theta.size() / 35.0;
        QVERIFY(isClose(s->fidelity, fidelity));
        QVERIFY(isClose(s->smoothness, smoothness));
        QVERIFY(isClose(s->simplicity, simplicity));
        QVERIFY(isClose(s->energy, fidelity + 10.0 * smoothness + 0.02 * simplicity));
    }
}

void SegmentationTest::labelsAndModelsBelongTogether()
{
    const auto s = segmentRoof(smallOptions());
    QVERIFY(s.ok());
    QCOMPARE(s->labels.size(), roof().mesh.vertices.size());
    const std::set<int> used(s->labels.begin(), s->labels.end());
    QCOMPARE(used.size(), s->models.size());
    QCOMPARE(*used.begin(), 0);
    QCOMPARE(*used.rbegin(), int(s->models.size()) - 1);
    for (const ImplicitPolynomial &m : s->models)
        QCOMPARE(m.theta.size(), Eigen::Index(monomialCount(m.degree)));
    QVERIFY(s->iterations >= 1 && s->iterations <= smallOptions().maxIterations);
}

// A single vertex that takes another used label is an expansion: a minimum allows none that pays.
void SegmentationTest::noOtherLabelOfOneVertexIsBetter()
{
    const auto s = segmentRoof(smallOptions());
    QVERIFY(s.ok());
    const Association &a = roof().association;
    double totalWeight = 0.0;
    for (double w : a.edgeWeights)
        totalWeight += w;
    const auto cost = [&](std::size_t v, int label) {
        double sum = 0.0;
        for (int i : a.pointsOfVertex[v])
            sum += std::pow(std::min(1.0, std::abs(s->models[label].signedDistance(a.points[i].point))), 2);
        sum /= 1e-4 * a.pairCount;
        for (int e : roof().topology.vertexEdges[v])
            if (s->labels[roof().topology.neighbour(int(v), e)] != label)
                sum += 10.0 * a.edgeWeights[e] / totalWeight;
        return sum;
    };
    for (std::size_t v = 0; v < s->labels.size(); ++v)
        for (int label = 0; label < int(s->models.size()); ++label)
            QVERIFY(cost(v, s->labels[v]) <= cost(v, label) + 1e-9);
}

void SegmentationTest::sameSeedSameResult()
{
    const auto first = segmentRoof(smallOptions()), again = segmentRoof(smallOptions());
    QVERIFY(first.ok() && again.ok());
    QCOMPARE(first->labels, again->labels);
    QVERIFY(first->energy == again->energy);
    QVERIFY(first->runEnergies == again->runEnergies);
    for (std::size_t i = 0; i < first->models.size(); ++i)
        QVERIFY(first->models[i].theta == again->models[i].theta);
}

void SegmentationTest::bestOfSeveralRuns()
{
    SegmentationOptions options = smallOptions();
    options.runs = 5;
    options.clusterCounts = {6};
    const auto s = segmentRoof(options);
    QVERIFY(s.ok());
    QCOMPARE(s->runEnergies.size(), std::size_t(5));
    for (double e : s->runEnergies)
        QVERIFY(s->energy <= e);
    QVERIFY(std::find(s->runEnergies.begin(), s->runEnergies.end(), s->energy) != s->runEnergies.end());
    // The first run alone is the first of the five.
    options.runs = 1;
    const auto one = segmentRoof(options);
    QVERIFY(one.ok());
    QCOMPARE(one->runEnergies.size(), std::size_t(1));
    QVERIFY(one->energy == s->runEnergies[0]);
}

void SegmentationTest::simplicityDecidesTheNumberOfModels()
{
    const auto parameters = [](const Segmentation &s) {
        int count = 0;
        for (const ImplicitPolynomial &m : s.models)
            count += int(m.theta.size());
        return count;
    };
    SegmentationOptions options = smallOptions();
    options.simplicity = 0.0;
    const auto free = segmentRoof(options);
    options.simplicity = 1e6;
    const auto dear = segmentRoof(options);
    QVERIFY(free.ok() && dear.ok());
    QCOMPARE(dear->models.size(), std::size_t(1));
    QVERIFY(free->models.size() >= 2);
    QVERIFY(parameters(*free) > parameters(*dear));
    QVERIFY(free->fidelity < dear->fidelity);
}

void SegmentationTest::cancelledAtAnyProgress()
{
    int reports = 0;
    const auto whole =
        segmentRoof(smallOptions(), JobControl(nullptr, [&](double, std::string_view) { ++reports; }));
    QVERIFY(whole.ok());
    QVERIFY(reports >= 2);
    for (int at : {0, 1, reports / 2}) {
        std::atomic<bool> cancel = at == 0;
        std::atomic<int> seen = 0;
        const JobControl control(&cancel, [&](double, std::string_view) {
            if (++seen >= at)
                cancel = true;
        });
        const auto s = segmentRoof(smallOptions(), control);
        QVERIFY(!s.ok());
        QVERIFY(s.error().isCancelled());
    }
}

QTEST_APPLESS_MAIN(SegmentationTest)
#include "segmentation_test.moc"
