// thumbnail as a file manager starts it: the size asked for, whatever the painting; refusals leave nothing.
#include "layerpainter/cli/thumbnail_command.h"

#include "document/document_files.h"
#include "formats/png_file.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class ThumbnailCommandTest : public QObject
{
    Q_OBJECT
private slots:
    void drawsThePaintingInEachLook();
    void refusesInWords_data();
    void refusesInWords();

private:
    QString file(const QString &name) const { return mFolder.filePath(name); }
    QTemporaryDir mFolder;
    QString mSample = QStringLiteral(DUCTUS_SOURCE_DIR "/resources/samples/forest-path.ductus");
};

void ThumbnailCommandTest::drawsThePaintingInEachLook()
{
    const auto drawn = [&](const QString &name, const QStringList &more) {
        QCOMPARE(int(runThumbnailCommand(QStringList{mSample, "-q", "-o", file(name)} + more)), 0);
    };
    drawn("a.png", {});
    drawn("dawn.png", {"--size", "80", "--look", "dawn"});
    drawn("day.png", {"--size", "80", "--look", "day"});
    const Result<Image> usual = readPng(enginePath(file("a.png"))),
                        dawn = readPng(enginePath(file("dawn.png"))),
                        day = readPng(enginePath(file("day.png")));
    QVERIFY(usual.ok() && dawn.ok() && day.ok());
    QCOMPARE(std::max(usual->width, usual->height), 256);
    QCOMPARE(dawn->width, 80);
    QCOMPARE(dawn->height, 50);
    std::size_t different = 0;
    for (std::size_t i = 0; i < dawn->pixels.size(); ++i)
        different += std::abs(int(dawn->pixels[i]) - int(day->pixels[i])) > 10;
    QVERIFY2(different > dawn->pixels.size() / 4, qPrintable(QString::number(different)));
}

void ThumbnailCommandTest::refusesInWords_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::newRow("no output") << QStringList{"x.ductus"} << 2;
    QTest::newRow("another kind") << QStringList{"x.ductus", "-o", "x.jpg"} << 2;
    QTest::newRow("no size") << QStringList{"x.ductus", "-o", "x.png", "--size", "0"} << 2;
    QTest::newRow("no such file") << QStringList{"none.ductus", "-o", "x.png"} << 1;
    QTest::newRow("no such look") << QStringList{"SAMPLE", "-o", "x.png", "--look", "none"} << 1;
    QTest::newRow("no such folder") << QStringList{"SAMPLE", "-o", "none/x.png"} << 1;
}

void ThumbnailCommandTest::refusesInWords()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    arguments.replaceInStrings(QStringLiteral("SAMPLE"), mSample);
    const QString before = QDir::currentPath();
    QDir::setCurrent(mFolder.path());
    const int found = int(runThumbnailCommand(arguments));
    QDir::setCurrent(before);
    QCOMPARE(found, code);
    QVERIFY(QDir(mFolder.path()).entryList({"x.*"}).isEmpty());
}

QTEST_GUILESS_MAIN(ThumbnailCommandTest)
#include "thumbnail_command_test.moc"
