#include "imaging/side_by_side.h"

#include <QtTest>

using namespace ductus;

class SideBySideTest : public QObject
{
    Q_OBJECT
private slots:
    void imagesStandInARowAlignedAtTheMiddle();
    void emptyImagesCountAsAbsent();
};

void SideBySideTest::imagesStandInARowAlignedAtTheMiddle()
{
    const Rgba red{255, 0, 0, 255}, green{0, 255, 0, 128}, grey{9, 9, 9, 255};
    const Image row = sideBySide({Image(2, 5, red), Image(3, 1, green)}, 4, grey);
    QCOMPARE(row.width, 9);
    QCOMPARE(row.height, 5);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 9; ++x)
            QCOMPARE(row.at(x, y), x < 2 ? red : (x >= 6 && y == 2 ? green : grey));
    }
}

void SideBySideTest::emptyImagesCountAsAbsent()
{
    QCOMPARE(sideBySide({}).width, 0);
    const Image one(4, 3, {1, 2, 3, 4});
    QCOMPARE(sideBySide({Image(), one, Image()}, 10).pixels, one.pixels);
    QCOMPARE(sideBySide({one, one}, -3).width, 8);
}

QTEST_APPLESS_MAIN(SideBySideTest)
#include "side_by_side_test.moc"
