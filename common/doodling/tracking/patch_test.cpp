#include "doodling/tracking/patch.h"

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
};

QTEST_APPLESS_MAIN(PatchTest)
#include "patch_test.moc"
