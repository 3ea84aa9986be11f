// Hands that hold the world, strokes in the air, and what is touched.
#include "layerpainter/vr/hands/near_stroke.h"
#include "layerpainter/vr/hands/space_stroke.h"
#include "layerpainter/vr/hands/world_grab.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"

#include <QtTest>
#include <numbers>

using namespace ductus;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

RoomPose at(double x, double y, double z, const Eigen::Quaterniond &turn = Eigen::Quaterniond::Identity())
{
    return {{x, y, z}, turn};
}

Placement somewhere()
{
    Placement placement;
    placement.rotation = AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());
    placement.scale = 0.4;
    placement.translation = {0.1, 0.9, -0.5};
    return placement;
}

bool areNear(const Vector3d &a, const Vector3d &b, double off = 1e-9)
{
    return (a - b).norm() < off;
}

} // namespace

class WorldGrabTest : public QObject
{
    Q_OBJECT
private slots:
    void oneHandCarriesWhatItHolds();
    void twoHandsKeepBothPoints();
    void nothingJumpsWhenHandsChange();
    void widthIsPressure();
    void theNearestSkinIsTouched();
};

void WorldGrabTest::oneHandCarriesWhatItHolds()
{
    WorldGrab grab;
    const Placement start = somewhere();
    const RoomPose before = at(0.2, 1.2, -0.3);
    QVERIFY(grab.move({}, before, start) == start);
    const RoomPose after = at(0.4, 1.0, -0.2, Eigen::Quaterniond(AngleAxisd(1.1, Vector3d::UnitY())));
    const Placement moved = grab.move({}, after, start);
    // A point of the scene is where it was, as seen from the hand.
    const Vector3d p(1, -2, 0.5);
    const Vector3d inHand = before.orientation.conjugate() * (start.matrix() * p - before.position);
    const Vector3d now = after.orientation.conjugate() * (moved.matrix() * p - after.position);
    QVERIFY(areNear(inHand, now));
    QVERIFY(std::abs(moved.scale - start.scale) < 1e-12);
}

void WorldGrabTest::twoHandsKeepBothPoints()
{
    WorldGrab grab;
    const Placement start = somewhere();
    const RoomPose left = at(-0.2, 1.1, -0.4), right = at(0.3, 1.2, -0.3);
    (void)grab.move(left, right, start);
    const Eigen::Affine3d sceneFromRoom = start.matrix().inverse();
    const Vector3d heldLeft = sceneFromRoom * left.position, heldRight = sceneFromRoom * right.position;
    const RoomPose left2 = at(-0.5, 1.4, -0.4), right2 = at(0.4, 0.9, -0.8);
    const Placement moved = grab.move(left2, right2, start);
    QVERIFY(areNear(moved.matrix() * heldLeft, left2.position));
    QVERIFY(areNear(moved.matrix() * heldRight, right2.position));
    const double wider = (right2.position - left2.position).norm() / (right.position - left.position).norm();
    QVERIFY(std::abs(moved.scale / start.scale - wider) < 1e-9);
    // Both turn around the line between them.
    const Vector3d line = (right2.position - left2.position).normalized();
    const Eigen::Quaterniond swing = Eigen::Quaterniond::FromTwoVectors(right.position - left.position, line);
    const Eigen::Quaterniond turned = AngleAxisd(0.6, line) * swing;
    const Placement twisted =
        grab.move(RoomPose{left2.position, turned}, RoomPose{right2.position, turned}, start);
    QVERIFY(areNear(twisted.matrix() * heldLeft, left2.position));
    QVERIFY(std::abs(twisted.rotation.angularDistance(turned * start.rotation)) < 1e-9);
}

void WorldGrabTest::nothingJumpsWhenHandsChange()
{
    WorldGrab grab;
    Placement present = somewhere();
    (void)grab.move(at(0, 1, 0), {}, present);
    present = grab.move(at(0.1, 1, 0), {}, present);
    const Placement two = grab.move(at(0.1, 1, 0), at(0.5, 1, 0), present);
    QVERIFY(two == present);
    present = grab.move(at(0.0, 1, 0), at(0.6, 1, 0), two);
    QVERIFY(std::abs(present.scale / two.scale - 1.5) < 1e-9);
    QVERIFY(grab.move({}, at(0.6, 1, 0), present) == present);
    QVERIFY(grab.move({}, {}, present) == present);
    QVERIFY(!grab.isHeld());
    (void)grab.move(at(0, 1, 0), at(0.001, 1, 0), present); // hands that touch
    const Placement same = grab.move(at(0, 1, 0), at(0.002, 1.001, 0), present);
    QVERIFY(same.matrix().matrix().allFinite());
    QVERIFY(std::abs(same.scale - present.scale) < 1e-9);
}

void WorldGrabTest::widthIsPressure()
{
    Placement room = somewhere();
    SpaceStroke stroke({0.1, {1, 0, 0}, StrokeSection::Ribbon});
    const Eigen::Affine3d roomFromScene = room.matrix();
    for (int i = 0; i <= 10; ++i)
        QVERIFY(stroke.add({roomFromScene * Vector3d(0.1 * i, 0, 0), room.rotation}, 0.1 * i, room));
    QVERIFY(!stroke.add({roomFromScene * Vector3d(1.01, 0, 0), room.rotation}, 1, room)); // too near
    const std::vector<PaintedPoint> &points = stroke.shape().points;
    QCOMPARE(points.size(), std::size_t(11));
    for (int i = 1; i <= 10; ++i) {
        QVERIFY(areNear(points[std::size_t(i)].position.cast<double>(), Vector3d(0.1 * i, 0, 0), 1e-6));
        QVERIFY(std::abs(points[std::size_t(i)].halfWidth - 0.01f * float(i)) < 1e-7f);
    }
    QVERIFY(points[0].halfWidth > 0);
    QVERIFY(areNear(points[3].normal.cast<double>(), Vector3d::UnitY(), 1e-6));
}

void WorldGrabTest::theNearestSkinIsTouched()
{
    const auto bar = [](double y, double halfWidth, const Eigen::Vector3f &colour) {
        StrokeShape stroke;
        for (const double x : {-1.0, 0.0, 1.0})
            stroke.points.push_back({Eigen::Vector3f(float(x), float(y), 0), Eigen::Vector3f::UnitY(),
                                     float(halfWidth), colour, 1});
        return std::make_shared<const ElementShape>(stroke);
    };
    auto made = performed(Painting(), act::AddStack{"one", -1});
    QVERIFY(made.ok());
    const LayerId layer = made->painting.stacks[0].substrate->id;
    auto drawn = addElements(made->painting, layer, {bar(0, 0.1, {1, 0, 0}), bar(1, 0.4, {0, 1, 0})});
    QVERIFY(drawn.ok());
    const Painting &painting = drawn->painting;
    const auto touch = [&](double y, double reach) {
        return nearStroke(painting, 0, {0.3, y, 0}, reach, layer);
    };
    QVERIFY(!touch(0.35, 0.2));
    QCOMPARE(touch(0.3, 0.3)->element, drawn->elements[0]); // 0.2 from its skin, 0.3 from the other's
    QCOMPARE(touch(0.45, 0.3)->element,
             drawn->elements[1]); // nearer to its skin though farther from its middle
    QVERIFY(std::abs(touch(0.45, 0.3)->distance - 0.15) < 1e-6);
    QCOMPARE(touch(0.05, 0.01)->distance, 0.0);
    QCOMPARE(touch(1.2, 0.01)->colour, Eigen::Vector3f(0, 1, 0));
    Painting locked = painting;
    locked.stacks[0].substrate->locked = true;
    QVERIFY(!nearStroke(locked, 0, {0, 0, 0}, 1, layer));
}

QTEST_APPLESS_MAIN(WorldGrabTest)
#include "world_grab_test.moc"
