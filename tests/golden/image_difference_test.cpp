#include "golden/image_difference.h"

#include <QPainter>
#include <QtTest>

using namespace ductus;

class ImageDifferenceTest : public QObject
{
    Q_OBJECT
private slots:
    void aLetterMayMoveByAPixel();
    void aMissingPanelIsSeen();
    void aChangedColourIsSeen();
    void otherSizesNeverMatch();
    void whatIsKeptStillMatches();
};

namespace {

QImage drawing(int shift, bool panel, const QColor &ground = QColor(36, 40, 46))
{
    QImage image(640, 400, QImage::Format_RGB32);
    image.fill(ground);
    QPainter painter(&image);
    painter.setPen(QColor(230, 230, 230));
    for (int row = 0; row < 8; ++row)
        for (int i = 0; i < 20; ++i)
            painter.drawLine(20 + 9 * i + shift, 20 + 16 * row, 20 + 9 * i + shift, 29 + 16 * row);
    if (panel)
        painter.fillRect(QRect(480, 40, 120, 60), QColor(60, 110, 220));
    return image;
}

} // namespace

void ImageDifferenceTest::aLetterMayMoveByAPixel()
{
    DifferenceOptions options;
    options.channelTolerance = 40;
    QVERIFY(differenceOf(drawing(0, true), drawing(1, true), options).isMatch(options));
    QCOMPARE(differenceOf(drawing(0, true), drawing(0, true)).failingShare, 0.0);
}

void ImageDifferenceTest::aMissingPanelIsSeen()
{
    const ImageDifference difference = differenceOf(drawing(0, true), drawing(0, false));
    QVERIFY(!difference.isMatch());
    QVERIFY(difference.failingShare > 0.025 && difference.failingShare < 0.04);
    QCOMPARE(difference.picture.pixel(540 / 4, 70 / 4), qRgb(255, 40, 40));
}

void ImageDifferenceTest::aChangedColourIsSeen()
{
    QVERIFY(!differenceOf(drawing(0, true), drawing(0, true, QColor(70, 40, 46))).isMatch());
}

void ImageDifferenceTest::otherSizesNeverMatch()
{
    QVERIFY(!differenceOf(drawing(0, true), drawing(0, true).copy(0, 0, 639, 400)).isMatch());
    QVERIFY(!differenceOf(drawing(0, true), QImage()).isMatch());
}

void ImageDifferenceTest::whatIsKeptStillMatches()
{
    QCOMPARE(differenceOf(drawing(0, true), toBeKept(drawing(0, true))).failingShare, 0.0);
}

QTEST_GUILESS_MAIN(ImageDifferenceTest)
#include "image_difference_test.moc"
