// The tree, distances and directions of reach, against brute force.
#include "base/random.h"
#include "painting/coverage/box_tree.h"
#include "painting/coverage/reach.h"
#include "painting/coverage/stroke_segments.h"
#include "support/painting_scenes.h"

#include <QtTest>
#include <set>

using namespace ductus;

namespace {

Vec3 randomVector(Random &random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

} // namespace

class LookupTest : public QObject
{
    Q_OBJECT
private slots:
    void treeFindsWhatIsThere();
    void distancesAreThoseToTheSkin();
    void reachIsAcrossTheSubstrate();
};

void LookupTest::treeFindsWhatIsThere()
{
    Random random(1);
    std::vector<Box3> boxes(500);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i % 50 == 7)
            continue; // stays empty
        const Vec3 centre = randomVector(random, 1);
        boxes[i].add(centre);
        boxes[i].add(centre + randomVector(random, 0.1));
    }
    const BoxTree tree(boxes);
    for (int query = 0; query < 300; ++query) {
        Box3 box;
        box.add(randomVector(random, 1));
        box.add(box.min + randomVector(random, 0.2));
        std::set<int> expected, found;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (!boxes[i].isEmpty() && (boxes[i].min.array() <= box.max.array()).all() &&
                (box.min.array() <= boxes[i].max.array()).all())
                expected.insert(int(i));
        tree.forBox(box, [&](int thing) { QVERIFY(found.insert(thing).second); });
        QVERIFY(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
        QVERIFY(found.size() < 100); // not just all of them

        // The nearest box along a ray, and the nearest to a point.
        const Vec3 origin = randomVector(random, 2), direction = randomVector(random, 1);
        const auto entry = [&](const Box3 &one) {
            double from = 0, to = 1e300;
            for (int i = 0; i < 3; ++i) {
                const double a = (one.min[i] - origin[i]) / direction[i];
                const double b = (one.max[i] - origin[i]) / direction[i];
                from = std::max(from, std::min(a, b));
                to = std::min(to, std::max(a, b));
            }
            return from <= to ? from : 1e300;
        };
        const auto distance = [&](const Box3 &one) {
            return (one.min - origin).cwiseMax(origin - one.max).cwiseMax(0).norm();
        };
        double bestEntry = 1e300, bestDistance = 1e300, treeEntry = 1e300, treeDistance = 1e300;
        for (const Box3 &one : boxes)
            if (!one.isEmpty()) {
                bestEntry = std::min(bestEntry, entry(one));
                bestDistance = std::min(bestDistance, distance(one));
            }
        tree.forRay(origin, direction, 1e300,
                    [&](int i) { return treeEntry = std::min(treeEntry, entry(boxes[std::size_t(i)])); });
        tree.forNear(origin, 1e300, [&](int i) {
            return treeDistance = std::min(treeDistance, distance(boxes[std::size_t(i)]));
        });
        QCOMPARE(treeEntry, bestEntry);
        QCOMPARE(treeDistance, bestDistance);
    }
}

void LookupTest::distancesAreThoseToTheSkin()
{
    Random random(2);
    StrokeShape stroke = evenStroke(StrokeSection::Round, {{0, 0, 0}, {1, 0, 0}}, 0.3f, {1, 1, 1});
    stroke.points[1].halfWidth = 0.1f;
    std::vector<SegmentData> segments;
    appendStrokeSegments(stroke, Eigen::Affine3d::Identity(), 0, std::nullopt, segments);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 x = Vec3(0.5, 0, 0) + randomVector(random, 1);
        double expected = 1e300; // to the balls of which the hull is the union
        for (int k = 0; k <= 1000; ++k) {
            const double t = k / 1000.0;
            expected = std::min(expected, (x - Vec3(t, 0, 0)).norm() - (0.3 - 0.2 * t));
        }
        const SegmentDistance found = segmentDistance(segments[0], x);
        QVERIFY(std::abs(found.distance - expected) < 1e-4);
        // Along the direction by that distance one comes to the skin.
        if (found.distance > 1e-3) {
            QVERIFY(!segmentContains(segments[0], x - 0.999 * found.distance * found.direction));
            QVERIFY(segmentContains(segments[0], x - (found.distance + 1e-6) * found.direction));
        }
    }
}

void LookupTest::reachIsAcrossTheSubstrate()
{
    for (const bool bumpy : {false, true}) {
        const PaintingScene scene = bumpy ? toleranceOnBumps(0) : toleranceOnFlat(0);
        const ElementPlacements placements(scene.painting, 0);
        const Layer &substrate = *scene.painting.stacks[0].substrate;
        const Layer &mark = scene.painting.stacks[0].appearance[0];
        const LayerSolid below(substrate, substrate.properties, placements);
        LayerSolid solid(mark, mark.properties, placements);
        setReach(solid, {&below});
        for (const SegmentData &segment : solid.segments())
            for (const Eigen::Vector3f &reach : {segment.reachA, segment.reachB}) {
                QVERIFY(std::abs(reach.norm() - 1) < 1e-5);
                // The plate's normal exactly; over bumps within 15 degrees of it, whatever bump is nearest.
                QVERIFY(std::abs(reach.z()) > (bumpy ? 0.966 : 0.999999));
            }
        setReach(solid, {}); // without a substrate: across the stroke
        for (const SegmentData &segment : solid.segments())
            QVERIFY(std::abs(segment.reachA.norm() - 1) < 1e-5);
    }
}

QTEST_APPLESS_MAIN(LookupTest)
#include "lookup_test.moc"
