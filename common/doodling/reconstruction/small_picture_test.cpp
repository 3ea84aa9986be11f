#include "doodling/reconstruction/small_picture.h"

#include <QtTest>

using namespace ductus;

class SmallPictureTest : public QObject
{
    Q_OBJECT
private slots:
    void keepsLightAndColour()
    {
        Image image(64, 32);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x)
                image.set(x, y, x < 32 ? Rgba{255, 255, 255, 255} : Rgba{255, 0, 0, 255});
        const SmallPicture picture = smallPictureOf(image);
        QCOMPARE(picture.width, 32);
        QCOMPARE(picture.colourWidth, 16);
        const Eigen::Vector3f white = picture.labAt({8.0, 16.0}), red = picture.labAt({56.0, 16.0});
        QVERIFY((white - Eigen::Vector3f(255.0f, 128.0f, 128.0f)).norm() < 2.0f);
        // Red is L 53, a 80, b 67.
        QVERIFY((red - Eigen::Vector3f(136.0f, 208.0f, 195.0f)).norm() < 3.0f);
    }
    void liesBetweenPixelsAndEndsAtTheBorder()
    {
        Image image(64, 32);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x) {
                const auto grey = std::uint8_t(4 * x);
                image.set(x, y, {grey, grey, grey, 255});
            }
        const SmallPicture picture = smallPictureOf(image);
        const float a = picture.labAt({30.0, 10.0}).x(), b = picture.labAt({31.0, 10.0}).x(),
                    c = picture.labAt({32.0, 10.0}).x();
        QVERIFY(std::abs(b - 0.5f * (a + c)) < 1.0f && c > a);
        QCOMPARE(picture.labAt({-90.0, 10.0}), picture.labAt({0.0, 10.0}));
        QCOMPARE(picture.labAt({900.0, 99.0}), picture.labAt({64.0, 32.0}));
    }
    void onePixelIsAPictureToo()
    {
        const SmallPicture picture = smallPictureOf(Image(1, 1));
        QCOMPARE(picture.width, 1);
        QVERIFY(picture.labAt({0.5, 0.5}).allFinite());
    }
};

QTEST_APPLESS_MAIN(SmallPictureTest)
#include "small_picture_test.moc"
