#include "sketchsurfacer/ui/viewport/view_camera.h"

#include "geometry/inspection/ray_tree.h"
#include "sketchsurfacer/ui/viewport/length_text.h"
#include "sketchsurfacer/ui/viewport/view_mark.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

class ViewCameraTest : public QObject
{
    Q_OBJECT
private slots:
    void raysAndProjectionsAgree_data();
    void raysAndProjectionsAgree();
    void framesTheWholeBox();
    void zoomsToThePointer();
    void turnsAroundWhatWasGrabbed();
    void firstHitIsTheNearest();
    void looksFromWhereItIsTold();
    void fliesTheShortWayRound();
    void findsASideNothingHides();
    void lengthsReadWell();
};

void ViewCameraTest::raysAndProjectionsAgree_data()
{
    QTest::addColumn<bool>("perspective");
    QTest::addColumn<bool>("zUp");
    QTest::newRow("perspective") << true << false;
    QTest::newRow("orthographic") << false << false;
    QTest::newRow("perspective, z up") << true << true;
}

void ViewCameraTest::raysAndProjectionsAgree()
{
    QFETCH(bool, perspective);
    QFETCH(bool, zUp);
    ViewCamera camera;
    camera.setViewport({800, 500});
    camera.setUpAxis(zUp ? UpAxis::Z : UpAxis::Y);
    camera.setPerspective(perspective);
    camera.orbit({37, -12});
    for (const Vec3 &point : {Vec3(0.1, 0.2, -0.3), Vec3(-0.4, 0.1, 0.5), Vec3(0, 0, 0)}) {
        const auto at = camera.project(point);
        QVERIFY(at);
        const ViewRay ray = camera.ray(*at);
        const Vec3 offset = point - ray.origin;
        QVERIFY((offset - offset.dot(ray.direction) * ray.direction).norm() < 1e-9);
        QVERIFY((camera.onViewPlane(*at, point) - point).norm() < 1e-9);
    }
    QVERIFY(std::abs(camera.right().dot(camera.worldUp())) < 1e-12); // the horizon is level
}

void ViewCameraTest::framesTheWholeBox()
{
    Box3 box;
    box.add({-3, 0, -1});
    box.add({3, 1, 1});
    for (const ViewPreset preset :
         {ViewPreset::Front, ViewPreset::Top, ViewPreset::Left, ViewPreset::ThreeQuarter}) {
        ViewCamera camera;
        camera.setViewport({600, 700});
        camera.setPreset(preset);
        camera.frame(box);
        double widest = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const auto at =
                camera.project({corner & 1 ? 3.0 : -3.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : -1.0});
            QVERIFY(at && QRectF(0, 0, 600, 700).contains(*at));
            widest = std::max(widest, std::abs(at->x() - 300) / 300);
            widest = std::max(widest, std::abs(at->y() - 350) / 350);
        }
        QVERIFY(widest > 0.5); // and fills the picture
    }
}

void ViewCameraTest::zoomsToThePointer()
{
    ViewCamera camera;
    camera.setViewport({800, 500});
    const QPointF pointer(620, 130);
    const Vec3 under = camera.onViewPlane(pointer, camera.target());
    camera.zoom(0.5, pointer);
    const auto at = camera.project(under);
    QVERIFY(at && std::hypot(at->x() - pointer.x(), at->y() - pointer.y()) < 1e-6);
}

void ViewCameraTest::turnsAroundWhatWasGrabbed()
{
    ViewCamera camera;
    const Vec3 grabbed = camera.onViewPlane({200, 180}, camera.target());
    camera.setTarget(grabbed);
    camera.orbit({60, 25});
    const auto at = camera.project(grabbed);
    QVERIFY(at && std::hypot(at->x() - 200, at->y() - 180) < 1e-6);
}

void ViewCameraTest::firstHitIsTheNearest()
{
    TriangleMesh mesh; // ten parallel triangles along z
    for (int i = 0; i < 10; ++i) {
        const int first = mesh.vertexCount();
        mesh.vertices.insert(mesh.vertices.end(),
                             {{-1, -1, double(i)}, {1, -1, double(i)}, {0, 1, double(i)}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    const RayTree tree(mesh);
    const auto hit = tree.firstHit({0, 0, 3.5}, Vec3::UnitZ());
    QVERIFY(hit);
    QCOMPARE(hit->triangle, 4);
    QVERIFY(std::abs(hit->distance - 0.5) < 1e-12);
    QVERIFY(hit->normal.z() < 0.0); // towards the eye
    QCOMPARE(tree.firstHit({0, 0, 3.5}, -Vec3::UnitZ())->triangle, 3);
    QVERIFY(!tree.firstHit({5, 0, -1}, Vec3::UnitZ()));
    QVERIFY(tree.isBlocked({0, 0, 3.5}, Vec3::UnitZ(), 0.0, 0.6));
    QVERIFY(!tree.isBlocked({0, 0, 3.5}, Vec3::UnitZ(), 0.0, 0.4));
    QVERIFY(!RayTree().firstHit({0, 0, 0}, Vec3::UnitZ()));
}

void ViewCameraTest::looksFromWhereItIsTold()
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (const Vec3 &from : {Vec3(1, 0.3, 0.2), Vec3(-0.4, 0.1, -1), Vec3(0.2, -0.5, 0.7)}) {
            ViewCamera camera;
            camera.setUpAxis(up);
            camera.lookFrom(from);
            QVERIFY((camera.forward() + from.normalized()).norm() < 1e-9);
        }
}

void ViewCameraTest::fliesTheShortWayRound()
{
    ViewCamera from, to;
    from.lookFrom(Vec3(-0.1, 0, -1)); // either side of where the angle jumps
    to.lookFrom(Vec3(0.1, 0, -1));
    QVERIFY((from.towards(to, 0.0).forward() - from.forward()).norm() < 1e-9);
    QVERIFY((from.towards(to, 0.5).forward() - Vec3::UnitZ()).norm() < 1e-9);
    QVERIFY(from.towards(to, 1.0) == to);
}

void ViewCameraTest::findsASideNothingHides()
{
    // A place in the plane z = 0, with a wide wall before it at z = 1.
    TriangleMesh wall;
    wall.vertices = {{-9, -9, 1}, {9, -9, 1}, {0, 18, 1}};
    wall.triangles = {{0, 1, 2}};
    const RayTree tree(wall);
    const Vec3 ahead = Vec3::UnitZ();
    const Vec3 found = freeDirection({Vec3::Zero(), std::nullopt, {}}, tree, ahead, 0.01);
    QVERIFY(found != ahead && std::abs(found.norm() - 1.0) < 1e-9);
    QVERIFY(!tree.isBlocked(Vec3::Zero(), found, 0.0, 1e300));
    QVERIFY(freeDirection({Vec3::Zero(), std::nullopt, {}}, tree, -ahead, 0.01) == -ahead);
    // Between a place behind the wall and one before it the middle is seen.
    QVERIFY(freeDirection({Vec3::Zero(), Vec3(0, 0, 4), {}}, tree, ahead, 0.01) == ahead);
}

void ViewCameraTest::lengthsReadWell()
{
    const QLocale english(QLocale::English, QLocale::UnitedStates);
    const auto text = [&](double metres) { return lengthText(metres, english).replace(QChar(0x00a0), ' '); };
    QCOMPARE(text(0.0124), QString("12.4 mm"));
    QCOMPARE(text(0.5), QString("50 cm"));
    QCOMPARE(text(4.52), QString("4.52 m"));
    QCOMPARE(text(0.0), QString("0 mm"));
    QCOMPARE(roundLength(0.07), 0.05);
    QCOMPARE(roundLength(0.0), 0.0);
    QCOMPARE(lengthText(0.0124, QLocale(QLocale::German)).replace(QChar(0x00a0), ' '), QString("12,4 mm"));
}

QTEST_MAIN(ViewCameraTest)
#include "view_camera_test.moc"
