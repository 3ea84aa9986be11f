#include "surfacing/association/association.h"

#include "support/mesh_zoo.h"

#include <QtTest>
#include <set>

using namespace ductus;

namespace {

constexpr int cells = 16;

struct Square
{
    TriangleMesh mesh = zoo::grid(cells);
    MeshTopology topology{mesh};
};

Stroke line(const Vec3 &from, const Vec3 &to, int segments)
{
    Stroke stroke;
    for (int i = 0; i <= segments; ++i)
        stroke.points.push_back(from + (to - from) * i / double(segments));
    return stroke;
}

StrokeSet setOf(std::vector<Stroke> strokes)
{
    StrokeSet set;
    for (Stroke &stroke : strokes) {
        stroke.id.value = int(set.strokes.size());
        set.strokes.push_back(std::move(stroke));
    }
    return set;
}

double turn(const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Seen from above.
bool crosses(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &d)
{
    return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

Association associated(const StrokeSet &strokes, const Square &square)
{
    Result<Association> result = associate(strokes, square.mesh, square.topology, {}, {});
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return std::move(*result);
}

bool isSame(const Association &a, const Association &b)
{
    bool same = a.points.size() == b.points.size() && a.pointsOfVertex == b.pointsOfVertex &&
                a.edgeWeights == b.edgeWeights && a.edgeIsCrossed == b.edgeIsCrossed;
    for (std::size_t i = 0; same && i < a.points.size(); ++i)
        same = a.points[i].point == b.points[i].point && a.samples[i].edge == b.samples[i].edge;
    return same;
}

} // namespace

class AssociationTest : public QObject
{
    Q_OBJECT
private slots:
    void crossesTheEdgesGeometrySays();
    void samplesStandOnTheirStrokeNearTheirEdge();
    void samplesOfOneSegmentAreEvenlySpaced();
    void eachVertexTakesTheClosestPointOfEachEdge();
    void evenMeshHasWeightsOneAndHundred();
    void weightsFollowTheSizeOfTheTriangles();
    void farStrokesAreNamed();
    void nothingNearIsRefused();
    void otherRolesAreIgnored();
    void lonePointsSpeakForTheirTriangle();
    void cancelled();
};

void AssociationTest::crossesTheEdgesGeometrySays()
{
    const Square square;
    const Vec3 from(0.031, 0.212, 0.004), to(0.964, 0.707, 0.004);
    const Association a = associated(setOf({line(from, to, 800)}), square);
    int crossed = 0;
    for (std::size_t e = 0; e < square.topology.edges.size(); ++e) {
        const MeshEdge &edge = square.topology.edges[e];
        const bool expected = crosses(from, to, square.mesh.vertices[edge.v0], square.mesh.vertices[edge.v1]);
        QCOMPARE(bool(a.edgeIsCrossed[e]), expected);
        crossed += expected;
    }
    QVERIFY(crossed > 25);
    QCOMPARE(a.points.size(), std::size_t(crossed)); // straight: each edge once
    QCOMPARE(a.samples.size(), a.points.size());
    QVERIFY(a.unreachedStrokes.empty());
}

void AssociationTest::samplesStandOnTheirStrokeNearTheirEdge()
{
    const Square square;
    const Vec3 from(0.05, 0.93, 0.01), to(0.9, 0.11, 0.01);
    const Association a = associated(setOf({line(from, to, 400)}), square);
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        const Vec3 p = a.points[i].point;
        const Vec3 along = (to - from).normalized();
        QVERIFY(((p - from) - along.dot(p - from) * along).norm() < 1e-12);
        const MeshEdge &edge = square.topology.edges[a.samples[i].edge];
        const Vec3 u = square.mesh.vertices[edge.v0], v = square.mesh.vertices[edge.v1];
        const double t = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
        QVERIFY((u + t * (v - u) - p).norm() < 0.015); // height and one step
        QCOMPARE(a.samples[i].stroke, 0);
        QVERIFY((a.points[i].normal - Vec3::UnitZ()).norm() < 1e-9);
    }
}

void AssociationTest::samplesOfOneSegmentAreEvenlySpaced()
{
    const Square square;
    const Vec3 from(0.22, 0.338, 0.0), to(0.43, 0.338, 0.0);
    const Association a = associated(setOf({line(from, to, 1)}), square);
    const int n = int(a.points.size());
    QVERIFY(n >= 4);
    for (int k = 0; k < n; ++k)
        QVERIFY((a.points[k].point - (from + (k + 0.5) / n * (to - from))).norm() < 1e-12);
}

void AssociationTest::eachVertexTakesTheClosestPointOfEachEdge()
{
    const Square square;
    std::vector<Stroke> strokes;
    for (double y : {0.33, 0.345, 0.351, 0.6, 0.612}) // several over the same edges
        strokes.push_back(line({0.05, y, 0.002}, {0.95, y + 0.02, 0.002}, 300));
    strokes.push_back(line({0.47, 0.02, 0.0}, {0.45, 0.98, 0.0}, 300));
    const Association a = associated(setOf(strokes), square);
    int pairs = 0, edgesWithSeveral = 0;
    QCOMPARE(a.pointsOfVertex.size(), square.mesh.vertices.size());
    for (int v = 0; v < square.mesh.vertexCount(); ++v) {
        std::multiset<int> expected;
        for (int e : square.topology.vertexEdges[v]) {
            int best = -1, candidates = 0;
            for (std::size_t i = 0; i < a.samples.size(); ++i) {
                if (a.samples[i].edge != e)
                    continue;
                ++candidates;
                if (best < 0 || (a.points[i].point - square.mesh.vertices[v]).norm() <
                                    (a.points[best].point - square.mesh.vertices[v]).norm())
                    best = int(i);
            }
            if (best >= 0)
                expected.insert(best);
            edgesWithSeveral += candidates > 1;
        }
        QCOMPARE(std::multiset<int>(a.pointsOfVertex[v].begin(), a.pointsOfVertex[v].end()), expected);
        pairs += int(expected.size());
    }
    QVERIFY(edgesWithSeveral > 20);
    QCOMPARE(a.pairCount, pairs);
}

void AssociationTest::evenMeshHasWeightsOneAndHundred()
{
    Square square;
    for (Vec3 &p : square.mesh.vertices) // equilateral triangles
        p = Vec3(p.x() - 0.5 * p.y(), std::sqrt(0.75) * p.y(), 0.0);
    const Association a = associated(setOf({line({0.1, 0.3, 0.0}, {0.7, 0.31, 0.0}, 300)}), square);
    int crossed = 0;
    for (std::size_t e = 0; e < square.topology.edges.size(); ++e) {
        if (square.topology.edges[e].faceCount != 2)
            continue;
        QVERIFY(std::abs(a.edgeWeights[e] - (a.edgeIsCrossed[e] ? 1.0 : 100.0)) < 1e-9);
        crossed += a.edgeIsCrossed[e];
    }
    QVERIFY(crossed > 10);
}

void AssociationTest::weightsFollowTheSizeOfTheTriangles()
{
    Square square;
    for (Vec3 &p : square.mesh.vertices) // cells grow to the right
        p.x() = 0.3 * p.x() + 0.7 * p.x() * p.x();
    AssociationOptions options;
    options.crossedEdgeWeight = 3.0;
    options.uncrossedEdgeWeight = 50.0;
    const auto a = associate(setOf({line({0.1, 0.3, 0.0}, {0.9, 0.5, 0.0}, 300)}), square.mesh,
                             square.topology, options, {});
    QVERIFY(a.ok());
    double unit = -1.0; // weight over size, equal for all edges
    for (std::size_t e = 0; e < square.topology.edges.size(); ++e) {
        const MeshEdge &edge = square.topology.edges[e];
        if (edge.faceCount != 2)
            continue;
        Vec3 opposite[2];
        for (int side : {0, 1})
            for (int v : square.mesh.triangles[edge.faces[side]])
                if (v != edge.v0 && v != edge.v1)
                    opposite[side] = square.mesh.vertices[v];
        const double plain = a->edgeIsCrossed[e] ? 3.0 : 50.0;
        const double ratio = a->edgeWeights[e] / plain / (opposite[0] - opposite[1]).norm();
        if (unit < 0.0)
            unit = ratio;
        QVERIFY(std::abs(ratio - unit) < 1e-9 * unit);
    }
}

void AssociationTest::farStrokesAreNamed()
{
    const Square square;
    const Stroke near = line({0.1, 0.2, 0.01}, {0.9, 0.4, 0.01}, 100);
    const Stroke far = line({0.1, 0.2, 0.3}, {0.9, 0.4, 0.3}, 100);
    Stroke leaving = line({0.1, 0.6, 0.0}, {0.9, 0.6, 0.4}, 400); // half of it too far away
    const Association a = associated(setOf({far, near, leaving}), square);
    QCOMPARE(a.unreachedStrokes, std::vector<int>{0});
    for (const StrokeSample &sample : a.samples)
        QVERIFY(sample.stroke != 0);
    double highest = 0.0;
    for (std::size_t i = 0; i < a.points.size(); ++i)
        if (a.samples[i].stroke == 2)
            highest = std::max(highest, a.points[i].point.z());
    QVERIFY(highest > 0.05 && highest <= AssociationOptions().maxDistance + 1e-9);
}

void AssociationTest::nothingNearIsRefused()
{
    const Square square;
    const auto far =
        associate(setOf({line({0.1, 0.2, 5}, {0.9, 0.4, 5}, 100)}), square.mesh, square.topology, {}, {});
    QVERIFY(!far.ok());
    QCOMPARE(far.error().code, ErrorCode::TooLittleData);
    QVERIFY(!far.error().remedy.empty());
    const auto empty = associate(StrokeSet(), square.mesh, square.topology, {}, {});
    QVERIFY(!empty.ok());
    QCOMPARE(empty.error().code, ErrorCode::TooLittleData);
}

void AssociationTest::otherRolesAreIgnored()
{
    const Square square;
    const Stroke surface = line({0.1, 0.2, 0.01}, {0.9, 0.4, 0.01}, 100);
    Stroke other = line({0.1, 0.8, 0.01}, {0.9, 0.5, 0.01}, 100);
    const Association alone = associated(setOf({surface}), square);
    for (StrokeRole role : {StrokeRole::Ignored, StrokeRole::Inner, StrokeRole::Skeletal}) {
        other.role = role;
        const Association both = associated(setOf({surface, other}), square);
        QVERIFY(isSame(both, alone));
        QVERIFY(both.unreachedStrokes.empty());
    }
    other.role = StrokeRole::Boundary;
    const Association both = associated(setOf({surface, other}), square);
    QVERIFY(both.points.size() > alone.points.size());
}

// Of a cloud: they cross nothing, but the vertices around hear them.
void AssociationTest::lonePointsSpeakForTheirTriangle()
{
    const Square square;
    StrokeSet cloud;
    for (const Vec3 &p : {Vec3(0.03, 0.02, 0.01), Vec3(0.52, 0.77, -0.01), Vec3(0.5, 0.5, 3.0)}) {
        Stroke stroke;
        stroke.id.value = int(cloud.strokes.size());
        stroke.points = {p};
        cloud.strokes.push_back(stroke);
    }
    const Association a = associated(cloud, square);
    QCOMPARE(a.points.size(), std::size_t(2));
    QCOMPARE(a.unreachedStrokes, std::vector<int>{2});
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        const MeshEdge &edge = square.topology.edges[std::size_t(a.samples[i].edge)];
        for (int v : {edge.v0, edge.v1}) {
            QVERIFY((square.mesh.vertices[std::size_t(v)] - a.points[i].point).norm() < 2.0 / cells);
            QVERIFY(a.pointsOfVertex[std::size_t(v)] == std::vector<int>{int(i)});
        }
        QVERIFY(std::abs(a.points[i].normal.z()) > 0.99);
    }
    QCOMPARE(a.pairCount, 4);
    for (char crossed : a.edgeIsCrossed)
        QVERIFY(!crossed);
}

void AssociationTest::cancelled()
{
    const Square square;
    const std::atomic<bool> cancel = true;
    const auto a = associate(setOf({line({0.1, 0.2, 0}, {0.9, 0.4, 0}, 100)}), square.mesh, square.topology,
                             {}, JobControl(&cancel, {}));
    QVERIFY(!a.ok());
    QVERIFY(a.error().isCancelled());
}

QTEST_APPLESS_MAIN(AssociationTest)
#include "association_test.moc"
