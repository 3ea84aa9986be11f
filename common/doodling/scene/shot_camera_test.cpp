#include "doodling/scene/shot_camera.h"

#include <QtTest>

using namespace ductus;

class ShotCameraTest : public QObject
{
    Q_OBJECT
private slots:
    void projectsAsAPinholeDoes()
    {
        ShotCamera camera{Eigen::Isometry3d::Identity(), 500.0, {320.0, 240.0}};
        QCOMPARE(*camera.projected({0.2, -0.1, 2.0}), Vec2(320.0 + 50.0, 240.0 - 25.0));
        QVERIFY(!camera.projected({0.0, 0.0, -1.0}));
        QVERIFY(!camera.projected({1.0, 0.0, 0.0}));
    }
    void unprojectingUndoesProjecting()
    {
        ShotCamera camera{Eigen::Isometry3d::Identity(), 500.0, {320.0, 240.0}};
        camera.worldFromCamera.rotate(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()));
        camera.worldFromCamera.pretranslate(Vec3(0.3, -2.0, 5.0));
        const Vec3 point = camera.worldFromCamera * Vec3(0.4, 0.3, 3.5);
        QVERIFY(std::abs(camera.depthOf(point) - 3.5) < 1e-12);
        QVERIFY((camera.unprojected(*camera.projected(point), 3.5) - point).norm() < 1e-12);
    }
};

QTEST_APPLESS_MAIN(ShotCameraTest)
#include "shot_camera_test.moc"
