#include "layerpainter/document/texture_block.h"

#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class TextureBlockTest : public QObject
{
    Q_OBJECT
private slots:
    void slicesFollowTheirNumbers();
    void largeOnesAreScaledDown();
    void refusesInWords();

private:
    QString picture(const QString &name, const QSize &size, QRgb colour)
    {
        QImage image(size, QImage::Format_ARGB32);
        image.fill(colour);
        image.setPixel(0, 0, qRgb(255, 255, 255));
        const QString path = mFolder.filePath(name);
        return image.save(path) ? path : QString();
    }
    QTemporaryDir mFolder;
};

void TextureBlockTest::slicesFollowTheirNumbers()
{
    const QString ten = picture("s10.png", {3, 2}, qRgb(100, 100, 100)),
                  two = picture("s2.png", {3, 2}, qRgba(200, 200, 200, 51));
    Box3 box;
    box.add({1, 1, 1});
    box.add({3, 2, 2});
    const Result<TextureMask> texture = textureFromPictures({ten, two}, box);
    QVERIFY(texture.ok());
    QCOMPARE(texture->width, 3);
    QCOMPARE(texture->height, 2);
    QCOMPARE(texture->depth, 2);
    const std::vector<std::uint8_t> &values = *texture->values;
    QCOMPARE(values.size(), 12u);
    QCOMPARE(int(values[0]), 40);  // 200 of which a fifth is there
    QCOMPARE(int(values[3]), 255); // the picture's upper left corner is the block's upper one
    QCOMPARE(int(values[6]), 100);
    QCOMPARE(texture->placement.scale, 2.0);
    QVERIFY(texture->placement.translation.isApprox(Vec3(1, 0.5, 0.5)));
}

void TextureBlockTest::largeOnesAreScaledDown()
{
    const Result<TextureMask> texture =
        textureFromPictures({picture("large.png", {700, 20}, qRgb(7, 7, 7))}, {});
    QVERIFY(texture.ok());
    QCOMPARE(texture->width, 256);
    QCOMPARE(texture->height, 20);
    QCOMPARE(texture->values->size(), std::size_t(256 * 20));
}

void TextureBlockTest::refusesInWords()
{
    QVERIFY(!textureFromPictures({}, {}).ok());
    QVERIFY(!textureFromPictures({mFolder.filePath("none.png")}, {}).ok());
    const Result<TextureMask> mixed = textureFromPictures(
        {picture("a.png", {3, 2}, qRgb(0, 0, 0)), picture("b.png", {2, 2}, qRgb(0, 0, 0))}, {});
    QVERIFY(!mixed.ok());
    QVERIFY(mixed.error().place.find("b.png") != std::string::npos);
}

QTEST_GUILESS_MAIN(TextureBlockTest)
#include "texture_block_test.moc"
