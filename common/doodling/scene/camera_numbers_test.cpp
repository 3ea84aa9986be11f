#include "doodling/scene/camera_numbers.h"

#include "base/random.h"

#include <QtTest>

#include <limits>

using namespace ductus;

class CameraNumbersTest : public QObject
{
    Q_OBJECT
private slots:
    void comesBackBitForBit()
    {
        Random random(3);
        for (int i = 0; i < 2000; ++i) {
            const auto number = [&] { return random.uniform(-1.0, 1.0); };
            ShotCamera camera;
            // Turned by little and by much.
            const double angle = (i % 2 == 0 ? 3.1 : 1e-4) * number();
            camera.worldFromCamera.linear() =
                Eigen::AngleAxisd(angle, Vec3(number(), number(), number()).normalized()).toRotationMatrix();
            camera.worldFromCamera.translation() = Vec3(number(), number(), number());
            camera.focal = 500.0;
            const ShotCamera kept = storable(camera);
            QVERIFY(kept.worldFromCamera.isApprox(camera.worldFromCamera, 1e-12));
            const auto back = cameraOf(numbersOf(kept));
            QVERIFY(back);
            QVERIFY(back->worldFromCamera.matrix() == kept.worldFromCamera.matrix());
        }
    }
    void whatIsNoCameraIsRefused()
    {
        const std::array<double, numbersACamera> good =
            numbersOf({Eigen::Isometry3d::Identity(), 100.0, {5, 5}});
        QVERIFY(cameraOf(good));
        for (auto [place, number] : {std::pair{3, 0.5}, std::pair{7, 0.0}, std::pair{7, -1.0},
                                     std::pair{4, std::numeric_limits<double>::infinity()},
                                     std::pair{8, std::numeric_limits<double>::quiet_NaN()}}) {
            std::array<double, numbersACamera> bad = good;
            bad[std::size_t(place)] = number;
            QVERIFY(!cameraOf(bad));
        }
    }
};

QTEST_APPLESS_MAIN(CameraNumbersTest)
#include "camera_numbers_test.moc"
