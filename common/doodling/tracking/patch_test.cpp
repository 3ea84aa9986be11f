#include "doodling/tracking/patch.h"

#include <Eigen/Geometry>
#include <QtTest>

using namespace ductus;

class PatchTest : public QObject
{
    Q_OBJECT
private slots:
    void findsItselfAndTellsOthersApart()
    {
        Image image(200, 120);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const auto wave = std::uint8_t(128 + 90 * std::sin(0.11 * x) * std::cos(0.17 * y));
                image.set(x, y, {wave, std::uint8_t(255 - wave), std::uint8_t(x), 255});
            }
        const SmallPicture picture = smallPictureOf(image);
        const Vec2 here(83.0, 61.0);
        const Patch patch = patchAt(picture, here);
        QVERIFY(differenceAt(picture, here, patch) < 1e-3);
        double before = 0.0;
        for (double away : {1.0, 3.0, 6.0}) {
            const double difference = differenceAt(picture, here + Vec2(away, 0.0), patch);
            QVERIFY(difference > before);
            before = difference;
        }
        const double other = differenceAt(picture, {150.0, 30.0}, patch);
        QVERIFY2(other > 20.0 && other <= 40.0, qPrintable(QString::number(other)));
    }
    void knowsItselfTurnedAndGrown()
    {
        const auto colourAt = [](const Vec2 &at) {
            const auto wave = std::uint8_t(128 + 90 * std::sin(0.21 * at.x()) * std::cos(0.27 * at.y()));
            return Rgba{wave, std::uint8_t(255 - wave), 60, 255};
        };
        const Vec2 here(80.0, 60.0);
        const Eigen::Matrix2d warp = 1.3 * Eigen::Rotation2Dd(0.8).toRotationMatrix();
        Image before(160, 120), after = before;
        for (int y = 0; y < before.height; ++y)
            for (int x = 0; x < before.width; ++x) {
                const Vec2 offset = Vec2(x + 0.5, y + 0.5) - here;
                before.set(x, y, colourAt(offset));
                after.set(x, y, colourAt(warp.inverse() * offset));
            }
        const Patch patch = patchAt(smallPictureOf(before), here);
        const SmallPicture picture = smallPictureOf(after);
        const double plain = differenceAt(picture, here, patch),
                     warped = differenceAt(picture, here, patch, warp);
        QVERIFY2(warped < 0.3 * plain, qPrintable(QString("%1 of %2").arg(warped).arg(plain)));
    }
};

QTEST_APPLESS_MAIN(PatchTest)
#include "patch_test.moc"
