#include "surfacing/refinement/refinement.h"

#include "support/box_sketch.h"
#include "support/mesh_zoo.h"
#include "surfacing/refinement/region_cut.h"
#include "surfacing/segmentation/data_costs.h"

#include <QtTest>
#include <functional>
#include <set>

using namespace ductus;

namespace {

const Vec3 halfBox = Vec3(0.5, 0.32, 0.4) / (2.0 * Vec3(0.5, 0.32, 0.4).norm()); // diagonal 1
constexpr double plateau = 0.03; // height of a square drawn above the top, next to its middle
constexpr double plateauHalf = 0.09;
const Vec3 plateauCentre(0.12, 0.0, 0.08);
constexpr double step = 0.008;

Stroke line(const Vec3 &a, const Vec3 &b)
{
    return straightStroke(a, b, step);
}

// Edges of the box and two lines across each face in both directions; above the top the plateau.
StrokeSet sketch(bool withPlateau, bool isTopDivided)
{
    BoxSketchOptions box{halfBox, 0.6, step, {}};
    if (withPlateau || !isTopDivided) // the top has only its rim and what is drawn below
        box.isLeftOut = [](const Vec3 &a, const Vec3 &b) {
            const auto isInner = [](double x) { return std::abs(x) < 1.0; };
            return a.y() == 1.0 && b.y() == 1.0 && (isInner(a.x()) || isInner(a.z())) &&
                   (isInner(b.x()) || isInner(b.z()));
        };
    StrokeSet set = boxSketch(box);
    if (withPlateau) {
        const double y = halfBox.y() + plateau;
        for (double t : {-1.0, 0.0, 1.0})
            for (bool along : {false, true}) {
                const Vec3 u = along ? Vec3::UnitX() : Vec3::UnitZ(),
                           w = along ? Vec3::UnitZ() : Vec3::UnitX();
                Vec3 c = plateauCentre + t * plateauHalf * w;
                c.y() = y;
                set.strokes.push_back(line(c - plateauHalf * u, c + plateauHalf * u));
            }
        set.strokes.push_back(
            line(Vec3(-halfBox.x(), halfBox.y(), -0.1), Vec3(halfBox.x(), halfBox.y(), -0.1)));
        set.strokes.push_back(
            line(Vec3(-0.1, halfBox.y(), -halfBox.z()), Vec3(-0.1, halfBox.y(), halfBox.z())));
    }
    for (std::size_t s = 0; s < set.strokes.size(); ++s)
        set.strokes[s].id.value = int(s);
    return set;
}

// A box seen through a proxy, with regions set by hand.
class Scene
{
public:
    explicit Scene(bool withPlateau = false, bool isTopDivided = true)
        : mesh(boxProxy()), topology(mesh), nearest(mesh),
          association(*associate(sketch(withPlateau, isTopDivided), mesh, topology, {}, {})),
          domain{mesh, topology, nearest, association, frame, plane}
    {
    }

    /// Regions by \a labelAt, each with the model of the given degree that fits its strokes best.
    std::shared_ptr<const LabelSolution> solution(const std::function<int(const Vec3 &)> &labelAt,
                                                  int degree = 1) const
    {
        Segmentation s;
        for (const Vec3 &v : mesh.vertices)
            s.labels.push_back(labelAt(v));
        const int count = *std::max_element(s.labels.begin(), s.labels.end()) + 1;
        for (int a = 0; a < count; ++a) {
            std::vector<char> flags;
            for (int label : s.labels)
                flags.push_back(label == a);
            s.models.push_back(
                fitPolynomial(association.points, pointsOf(association, flags), degree, options.fit));
        }
        return std::make_shared<const LabelSolution>(unscribbled(domain, std::move(s), options));
    }

    std::shared_ptr<const LabelSolution> after(const std::shared_ptr<const LabelSolution> &start,
                                               const std::vector<Scribble> &scribbles) const
    {
        Result<std::shared_ptr<const LabelSolution>> result = refine(domain, start, scribbles, options, {});
        if (!result)
            qFatal("%s", result.error().message().c_str());
        return *result;
    }

    /// Labels on the vertices \a where holds.
    std::set<int> labelsWhere(const LabelSolution &s, const std::function<bool(const Vec3 &)> &where) const
    {
        std::set<int> labels;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            if (where(mesh.vertices[v]))
                labels.insert(s.segmentation.labels[v]);
        return labels;
    }

    int labelAt(const LabelSolution &s, const Vec3 &p) const
    {
        std::size_t best = 0;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            if ((mesh.vertices[v] - p).norm() < (mesh.vertices[best] - p).norm())
                best = v;
        return s.segmentation.labels[best];
    }

    TriangleMesh mesh;
    MeshTopology topology;
    NearestOnMesh nearest;
    Association association;
    UnitFrame frame;
    std::optional<SymmetryPlane> plane;
    SegmentationOptions options;
    ScribbleDomain domain;

private:
    static TriangleMesh boxProxy()
    {
        TriangleMesh mesh = zoo::icosphere(4);
        for (Vec3 &v : mesh.vertices)
            v = (v / v.cwiseAbs().maxCoeff()).cwiseProduct(halfBox);
        return mesh;
    }
};

int faceOf(const Vec3 &p)
{
    int axis = 0;
    p.cwiseQuotient(halfBox).cwiseAbs().maxCoeff(&axis);
    return 2 * axis + (p[axis] > 0.0);
}

constexpr int top = 3; // +y

bool isOnTop(const Vec3 &p) // well inside
{
    return p.y() > 0.999 * halfBox.y() && std::abs(p.x()) < 0.9 * halfBox.x() &&
           std::abs(p.z()) < 0.9 * halfBox.z();
}

// The top in three strips with two borders where no stroke is.
int overSegmented(const Vec3 &p)
{
    const int face = faceOf(p);
    if (face != top || std::abs(p.x()) < 0.05)
        return face;
    return p.x() < 0.0 ? 6 : 7;
}

Vec3 onTop(double x, double z)
{
    return {x, halfBox.y(), z};
}

Scribble scribble(ScribbleKind kind, std::vector<Vec3> points, int degree = 0)
{
    return {kind, std::move(points), degree};
}

} // namespace

class RefinementTest : public QObject
{
    Q_OBJECT
private slots:
    void mergeMakesOneRegionOfThree();
    void newRegionBringsBackALostDetail();
    void newRegionOnAFlatFaceTakesItsCell();
    void newRegionOnAnUndividedFaceStaysNear();
    void lockKeepsARegionFromALaterMerge();
    void splitAlongALine();
    void splitAroundARing();
    void splitOfAnOpenSurface();
    void splitSnapsToANearStroke();
    void seamRunsExactlyThere();
    void forbiddenSeamGoesAway();
    void degreeIsSet();
    void oneByOneIsAsAllTogether();
    void takingBackTheLastGivesTheSolutionBefore();
    void mirroredScribbleWorksOnTheSolvedHalf();
    void laterScribblesWinOverEarlierOnes();
    void uselessScribblesAreRefused();
};

void RefinementTest::mergeMakesOneRegionOfThree()
{
    const Scene scene;
    const auto before = scene.solution(overSegmented);
    QCOMPARE(scene.labelsWhere(*before, isOnTop).size(), std::size_t(3));
    const auto after =
        scene.after(before, {scribble(ScribbleKind::Merge, {onTop(-0.3, 0.02), onTop(0.3, -0.02)})});
    QCOMPARE(scene.labelsWhere(*after, isOnTop).size(), std::size_t(1));
    QCOMPARE(after->segmentation.models.size(), std::size_t(6));
    // The other faces are as they were.
    for (int face : {0, 1, 2, 4, 5}) {
        const auto inFace = [&](const Vec3 &p) {
            return faceOf(p) == face && (p.cwiseQuotient(halfBox).cwiseAbs().array() > 0.9).count() == 1;
        };
        QCOMPARE(scene.labelsWhere(*after, inFace).size(), std::size_t(1));
    }
}

void RefinementTest::newRegionBringsBackALostDetail()
{
    const Scene scene(true);
    const auto before = scene.solution(faceOf);
    const Vec3 inside = onTop(plateauCentre.x(), plateauCentre.z());
    QCOMPARE(scene.labelAt(*before, inside), scene.labelAt(*before, onTop(-0.2, -0.2)));
    const Vec3 way(0.05, 0.0, 0.04);
    const auto after = scene.after(before, {scribble(ScribbleKind::NewRegion, {inside - way, inside + way})});
    const int label = scene.labelAt(*after, inside);
    QVERIFY(label != scene.labelAt(*after, onTop(-0.2, -0.2)));
    QVERIFY(label != scene.labelAt(*after, onTop(0.12, -0.2)));
    // It is the plateau's plane and fills the plateau.
    const ImplicitPolynomial &model = after->segmentation.models[std::size_t(label)];
    const Vec3 above = inside + Vec3(0, plateau, 0);
    QVERIFY2(std::abs(model.signedDistance(above)) < 0.15 * plateau,
             qPrintable(QString::number(model.signedDistance(above))));
    for (double x : {-0.8, 0.8})
        for (double z : {-0.8, 0.8})
            QCOMPARE(scene.labelAt(*after, inside + plateauHalf * Vec3(x, 0, z)), label);
}

// Two lines in each direction divide the top into nine cells of one plane.
void RefinementTest::newRegionOnAFlatFaceTakesItsCell()
{
    const Scene scene;
    const auto before = scene.solution(faceOf);
    const auto after =
        scene.after(before, {scribble(ScribbleKind::NewRegion, {onTop(-0.05, 0.0), onTop(0.05, 0.0)})});
    const int label = scene.labelAt(*after, onTop(0.0, 0.0));
    const double edgeX = 0.6 * halfBox.x(), edgeZ = 0.6 * halfBox.z(), near = 0.03;
    int inside = 0;
    for (std::size_t v = 0; v < scene.mesh.vertices.size(); ++v) {
        const Vec3 &p = scene.mesh.vertices[v];
        if (!isOnTop(p))
            continue;
        const double x = std::abs(p.x()), z = std::abs(p.z());
        if (x < edgeX - near && z < edgeZ - near) {
            QCOMPARE(after->segmentation.labels[v], label);
            ++inside;
        } else if (x > edgeX + near || z > edgeZ + near) {
            QVERIFY(after->segmentation.labels[v] != label);
        }
    }
    QVERIFY(inside > 10);
}

void RefinementTest::newRegionOnAnUndividedFaceStaysNear()
{
    const Scene scene(false, false);
    const auto before = scene.solution(faceOf);
    const auto after =
        scene.after(before, {scribble(ScribbleKind::NewRegion, {onTop(-0.05, 0.0), onTop(0.05, 0.0)})});
    const int label = scene.labelAt(*after, onTop(0.0, 0.0));
    QCOMPARE(scene.labelAt(*after, onTop(0.05, 0.02)), label);
    QVERIFY(scene.labelAt(*after, onTop(0.2, 0.0)) != label);
    QVERIFY(scene.labelAt(*after, onTop(0.0, 0.15)) != label);
}

void RefinementTest::lockKeepsARegionFromALaterMerge()
{
    const Scene scene;
    const auto before = scene.solution(overSegmented);
    const Scribble merge = scribble(ScribbleKind::Merge, {onTop(-0.3, 0.02), onTop(0.3, -0.02)});
    const Scribble lock = scribble(ScribbleKind::Lock, {onTop(0.3, 0.1)});
    const auto after = scene.after(before, {lock, merge});
    QCOMPARE(scene.labelsWhere(*after, isOnTop).size(), std::size_t(2));
    const int locked = scene.labelAt(*after, onTop(0.3, 0.1));
    for (std::size_t v = 0; v < scene.mesh.vertices.size(); ++v) {
        const bool wasIn = before->segmentation.labels[v] == 7;
        QCOMPARE(after->segmentation.labels[v] == locked, wasIn);
        QCOMPARE(bool(after->vertexIsLocked[v]), wasIn);
    }
}

void RefinementTest::splitAlongALine()
{
    const Scene scene;
    const auto before = scene.solution(faceOf);
    // From border to border, and one that stops short of both.
    for (double reach : {1.1, 0.7}) {
        const double z = reach * halfBox.z();
        const auto after =
            scene.after(before, {scribble(ScribbleKind::Split, {onTop(0.02, -z), onTop(0.02, z)})});
        const int left = scene.labelAt(*after, onTop(-0.2, 0.0)),
                  right = scene.labelAt(*after, onTop(0.25, 0.0));
        QVERIFY(left != right);
        QCOMPARE(scene.labelsWhere(*after, isOnTop), (std::set<int>{left, right}));
        QCOMPARE(after->segmentation.models.size(), std::size_t(7));
    }
}

void RefinementTest::splitOfAnOpenSurface()
{
    const TriangleMesh sheet = zoo::grid(20, 0.1);
    const MeshTopology topology(sheet);
    const NearestOnMesh nearest(sheet);
    StrokeSet strokes;
    for (double y : {0.2, 0.5, 0.8})
        strokes.strokes.push_back(line(Vec3(0, y, 0), Vec3(1, y, 0)));
    Association association = *associate(strokes, sheet, topology, {}, {});
    const UnitFrame frame;
    const std::optional<SymmetryPlane> plane;
    const ScribbleDomain domain{sheet, topology, nearest, association, frame, plane};
    std::vector<int> all;
    for (int v = 0; v < sheet.vertexCount(); ++v)
        all.push_back(v);
    for (double end : {1.05, 1.0, 0.7}) { // beyond the border, on it, short of it
        const Result<ScribblePath> path =
            layOnProxy(domain, {Vec3(0.52, 1.0 - end, 0), Vec3(0.52, 0.5, 0.1), Vec3(0.52, end, 0)});
        QVERIFY(path.ok());
        const auto cut = cutAlong(domain, all, *path, CutEnds::Extended);
        QVERIFY2(cut.has_value(), qPrintable(QString::number(end)));
        QVERIFY(cut->left.size() > all.size() / 4 && cut->right.size() > all.size() / 4);
        for (int v : cut->left)
            QVERIFY(std::abs(sheet.vertices[std::size_t(v)].y() - 0.5) > 0.2 ||
                    sheet.vertices[std::size_t(v)].x() < 0.6);
    }
}

void RefinementTest::splitAroundARing()
{
    const Scene scene;
    const auto before = scene.solution(faceOf);
    std::vector<Vec3> ring;
    for (int i = 0; i < 30; ++i) // not quite closed
        ring.push_back(onTop(0.12 * std::cos(0.2 * i), 0.12 * std::sin(0.2 * i)));
    const auto after = scene.after(before, {scribble(ScribbleKind::Split, ring)});
    const int inside = scene.labelAt(*after, onTop(0, 0)), outside = scene.labelAt(*after, onTop(0.25, 0.2));
    QVERIFY(inside != outside);
    QCOMPARE(scene.labelAt(*after, onTop(-0.25, -0.2)), outside);
    for (const Vec3 &p : {onTop(0.05, 0.04), onTop(-0.05, 0.05), onTop(0.05, -0.05)})
        QCOMPARE(scene.labelAt(*after, p), inside);
}

void RefinementTest::splitSnapsToANearStroke()
{
    const Scene scene;
    const auto before = scene.solution(faceOf);
    const double stroke = 0.6 * halfBox.x(); // a line across the top, drawn along z
    const double z = 1.1 * halfBox.z(), beside = stroke - 0.03;
    const auto after =
        scene.after(before, {scribble(ScribbleKind::Split, {onTop(beside, -z), onTop(beside, z)})});
    int atStroke = 0, elsewhere = 0;
    for (std::size_t e = 0; e < scene.topology.edges.size(); ++e) {
        const MeshEdge &edge = scene.topology.edges[e];
        const Vec3 &a = scene.mesh.vertices[std::size_t(edge.v0)],
                   &b = scene.mesh.vertices[std::size_t(edge.v1)];
        if (isOnTop(a) && isOnTop(b) &&
            after->segmentation.labels[std::size_t(edge.v0)] !=
                after->segmentation.labels[std::size_t(edge.v1)])
            ++(scene.association.edgeIsCrossed[e] ? atStroke : elsewhere);
    }
    QVERIFY(atStroke > 5);
    QVERIFY2(elsewhere < atStroke / 5, qPrintable(QString("%1 of %2").arg(elsewhere).arg(atStroke)));
}

void RefinementTest::seamRunsExactlyThere()
{
    const Scene scene;
    const auto before = scene.solution(faceOf);
    const std::vector<Vec3> points{onTop(0.05, -1.2 * halfBox.z()), onTop(-0.05, 0.0),
                                   onTop(0.05, 1.2 * halfBox.z())};
    const Result<ScribblePath> path = layOnProxy(scene.domain, points);
    QVERIFY(path.ok());
    const auto after = scene.after(before, {scribble(ScribbleKind::Seam, points)});
    int crossed = 0;
    for (std::size_t i = 0; i < path->crossedEdges.size(); ++i) {
        const std::size_t l = std::size_t(path->left[i]), r = std::size_t(path->right[i]);
        if (!isOnTop(scene.mesh.vertices[l]) || !isOnTop(scene.mesh.vertices[r]))
            continue;
        ++crossed;
        QVERIFY(before->segmentation.labels[l] == before->segmentation.labels[r]);
        QVERIFY(after->segmentation.labels[l] != after->segmentation.labels[r]);
    }
    QVERIFY(crossed > 5);
    QCOMPARE(scene.labelsWhere(*after, isOnTop).size(), std::size_t(2));
}

void RefinementTest::forbiddenSeamGoesAway()
{
    const Scene scene;
    const auto before = scene.solution(overSegmented);
    const double z = halfBox.z();
    const auto after = scene.after(
        before, {scribble(ScribbleKind::ForbidSeam, {onTop(0.05, -z), onTop(0.05, 0), onTop(0.05, z)})});
    QCOMPARE(scene.labelAt(*before, onTop(0.03, 0)) == scene.labelAt(*before, onTop(0.07, 0)), false);
    QCOMPARE(scene.labelAt(*after, onTop(0.0, 0)), scene.labelAt(*after, onTop(0.2, 0)));
    QCOMPARE(scene.labelAt(*after, onTop(0.0, 0.1)), scene.labelAt(*after, onTop(0.3, 0.1)));
}

void RefinementTest::degreeIsSet()
{
    const Scene scene;
    const auto before = scene.solution(faceOf);
    const auto after = scene.after(before, {scribble(ScribbleKind::SetDegree, {onTop(0, 0)}, 3)});
    const auto degreeAt = [&](const LabelSolution &s, const Vec3 &p) {
        return s.segmentation.models[std::size_t(scene.labelAt(s, p))].degree;
    };
    QCOMPARE(degreeAt(*before, onTop(0, 0)), 1);
    QCOMPARE(degreeAt(*after, onTop(0, 0)), 3);
    QCOMPARE(scene.labelsWhere(*after, isOnTop).size(), std::size_t(1));
    QCOMPARE(degreeAt(*after, -onTop(0, 0)), 1);
    const auto back =
        scene.after(after, {after->scribbles[0], scribble(ScribbleKind::SetDegree, {onTop(0.1, 0)}, 2)});
    QCOMPARE(degreeAt(*back, onTop(0, 0)), 2);
}

void RefinementTest::oneByOneIsAsAllTogether()
{
    const Scene scene;
    const auto start = scene.solution(overSegmented);
    const std::vector<Scribble> all{
        scribble(ScribbleKind::Merge, {onTop(-0.3, 0.02), onTop(0.3, -0.02)}),
        scribble(ScribbleKind::Lock, {Vec3(halfBox.x(), 0, 0)}),
        scribble(ScribbleKind::Split, {onTop(0.02, -halfBox.z()), onTop(0.02, halfBox.z())}),
    };
    auto stepwise = start;
    for (std::size_t n = 1; n <= all.size(); ++n)
        stepwise = scene.after(stepwise, {all.begin(), all.begin() + long(n)});
    const auto together = scene.after(start, all);
    QCOMPARE(together->segmentation.labels, stepwise->segmentation.labels);
    QCOMPARE(together->modelIds, stepwise->modelIds);
    QVERIFY(together->segmentation.labels != start->segmentation.labels);
}

void RefinementTest::takingBackTheLastGivesTheSolutionBefore()
{
    const Scene scene;
    const Scribble merge = scribble(ScribbleKind::Merge, {onTop(-0.3, 0.02), onTop(0.3, -0.02)});
    const Scribble split =
        scribble(ScribbleKind::Split, {onTop(0.02, -halfBox.z()), onTop(0.02, halfBox.z())});
    const auto one = scene.after(scene.solution(overSegmented), {merge});
    const auto two = scene.after(one, {merge, split});
    QVERIFY(two != one);
    QVERIFY(scene.after(two, {merge}) == one); // the very object
}

void RefinementTest::mirroredScribbleWorksOnTheSolvedHalf()
{
    Scene scene;
    const auto before = scene.solution(overSegmented);
    scene.plane =
        SymmetryPlane{-Vec3::UnitY(), -2.0 * halfBox.y()}; // far above; everything lies on its kept side
    const auto mirrored = [](Vec3 p) {
        p.y() = 4.0 * halfBox.y() - p.y();
        return p;
    };
    const auto after = scene.after(
        before, {scribble(ScribbleKind::Merge, {mirrored(onTop(-0.3, 0.02)), mirrored(onTop(0.3, -0.02))})});
    QCOMPARE(scene.labelsWhere(*after, isOnTop).size(), std::size_t(1));
}

void RefinementTest::laterScribblesWinOverEarlierOnes()
{
    const Scene scene;
    const auto before = scene.solution(faceOf);
    const auto after = scene.after(
        before, {scribble(ScribbleKind::Split, {onTop(0.02, -halfBox.z()), onTop(0.02, halfBox.z())}),
                 scribble(ScribbleKind::Merge, {onTop(-0.2, 0.0), onTop(0.2, 0.0)})});
    QCOMPARE(scene.labelsWhere(*after, isOnTop).size(), std::size_t(1));
}

void RefinementTest::uselessScribblesAreRefused()
{
    const Scene scene;
    const auto start = scene.solution(faceOf);
    const auto errorOf = [&](const std::vector<Scribble> &scribbles) {
        const auto result = refine(scene.domain, start, scribbles, scene.options, {});
        return result ? Error{} : result.error();
    };
    const std::vector<std::vector<Scribble>> useless{
        {scribble(ScribbleKind::Merge, {})},
        {scribble(ScribbleKind::Merge, {Vec3(3, 3, 3)})},
        {scribble(ScribbleKind::SetDegree, {onTop(0, 0)}, 9)},
        {scribble(ScribbleKind::SetDegree, {onTop(0, 0)})},
        {scribble(ScribbleKind::Split, {onTop(0, 0)})},
    };
    for (const std::vector<Scribble> &scribbles : useless) {
        const Error error = errorOf(scribbles);
        QCOMPARE(error.code, ErrorCode::InvalidArgument);
        QCOMPARE(error.place, std::string("scribble 0"));
        QVERIFY(!error.problem.empty() && !error.remedy.empty());
    }
    const Error locked = errorOf({scribble(ScribbleKind::Lock, {onTop(0, 0)}),
                                  scribble(ScribbleKind::NewRegion, {onTop(-0.1, 0), onTop(0.1, 0)})});
    QCOMPARE(locked.place, std::string("scribble 1"));
}

QTEST_GUILESS_MAIN(RefinementTest)
#include "refinement_test.moc"
