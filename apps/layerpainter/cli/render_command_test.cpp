// render and replay as a script uses them: pictures, films, exit codes, and nothing left behind by a refusal.
#include "layerpainter/cli/render_command.h"
#include "layerpainter/cli/replay_command.h"

#include "document/document_files.h"
#include "formats/png_file.h"
#include "layerpainter/document/painting_project.h"
#include "project/project_reader.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class RenderCommandTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void drawsAStill();
    void theReferenceGivesTheSameBytes();
    void writesFilms();
    void refusesInWords_data();
    void refusesInWords();
    void replayRefusesInWords_data();
    void replayRefusesInWords();

private:
    QString file(const QString &name) const { return mFolder.filePath(name); }
    static QByteArray read(const QString &path)
    {
        QFile in(path);
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }

    QTemporaryDir mFolder;
    QString mSample = QStringLiteral(DUCTUS_SOURCE_DIR "/resources/samples/plane-over-clouds.ductus");
};

void RenderCommandTest::initTestCase()
{
    QVERIFY(mFolder.isValid());
    QVERIFY(QFile::exists(mSample));
}

void RenderCommandTest::drawsAStill()
{
    QCOMPARE(int(runRenderCommand({mSample, "-q", "-o", file("a.png"), "--size", "64x40"})), 0);
    const Result<Image> all = readPng(enginePath(file("a.png")));
    QVERIFY(all.ok());
    QCOMPARE(all->width, 64);
    QCOMPARE(all->height, 40);
    QCOMPARE(int(all->at(0, 0)[3]), 255);
    QCOMPARE(int(runRenderCommand({mSample, "-q", "-o", file("b.png"), "--size", "64x40", "--transparent"})),
             0);
    QCOMPARE(int(readPng(enginePath(file("b.png")))->at(2, 1)[3]), 0); // sky
    // Another second shows the plane elsewhere.
    QCOMPARE(int(runRenderCommand({mSample, "-q", "-o", file("c.png"), "--size", "64x40", "--time", "1.5"})),
             0);
    QVERIFY(readPng(enginePath(file("c.png")))->pixels != all->pixels);
}

void RenderCommandTest::theReferenceGivesTheSameBytes()
{
    for (const char *name : {"r1.png", "r2.png"})
        QCOMPARE(int(runRenderCommand(
                     {mSample, "-q", "-o", file(name), "--size", "48x30", "--reference", "--samples", "1"})),
                 0);
    QVERIFY(!read(file("r1.png")).isEmpty());
    QCOMPARE(read(file("r1.png")), read(file("r2.png")));
}

void RenderCommandTest::writesFilms()
{
    const auto film = [&](const QString &name, const QStringList &more) {
        return int(runRenderCommand(
            QStringList{mSample, "-q", "-o", file(name), "--size", "64x40", "--samples", "1"} + more));
    };
    QCOMPARE(film("f.mp4", {"--frames", "3"}), 0);
    QVERIFY(read(file("f.mp4")).mid(4, 4) == "ftyp");
    QCOMPARE(film("f.gif", {"--frames", "2", "--turntable", "-1"}), 0);
    QVERIFY(read(file("f.gif")).startsWith("GIF89a"));
    QCOMPARE(film("f.webm", {"--seconds", "0.1", "--fps", "30", "--transparent"}), 0);
    QVERIFY(read(file("f.webm")).startsWith("\x1a\x45\xdf\xa3"));
    QCOMPARE(film("frames", {"--frames", "2", "--every-look"}), 0);
    const QStringList folders = QDir(mFolder.path()).entryList({"frames-*"}, QDir::Dirs);
    QCOMPARE(folders.size(), 1); // the sample has one look
    QCOMPARE(QDir(file(folders[0])).entryList({"*.png"}).size(), 2);
}

void RenderCommandTest::refusesInWords_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    const auto row = [](const char *name, const QStringList &arguments, int code) {
        QTest::newRow(name) << arguments << code;
    };
    row("no output", {"x.ductus"}, 2);
    row("another kind", {"x.ductus", "-o", "x.avi"}, 2);
    row("no size", {"x.ductus", "-o", "x.png", "--size", "big"}, 2);
    row("no rate", {"x.ductus", "-o", "x.mp4", "--fps", "0"}, 2);
    row("length twice", {"x.ductus", "-o", "x.mp4", "--seconds", "1", "--frames", "3"}, 2);
    row("no turns", {"x.ductus", "-o", "x.mp4", "--turntable", "0"}, 2);
    row("look and every look", {"x.ductus", "-o", "x.mp4", "--look", "a", "--every-look"}, 2);
    row("no such file", {"none.ductus", "-o", "x.mp4"}, 1);
    row("no such look", {"SAMPLE", "-o", "x.mp4", "--look", "none"}, 1);
    row("clear MP4", {"SAMPLE", "-o", "x.mp4", "--transparent", "--frames", "1"}, 1);
    row("no such folder", {"SAMPLE", "-o", "none/x.png"}, 1);
}

void RenderCommandTest::refusesInWords()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    arguments.replaceInStrings(QStringLiteral("SAMPLE"), mSample);
    const QString before = QDir::currentPath();
    QDir::setCurrent(mFolder.path());
    const int found = int(runRenderCommand(arguments));
    QDir::setCurrent(before);
    QCOMPARE(found, code);
    QVERIFY(QDir(mFolder.path()).entryList({"x.*"}).isEmpty());
}

void RenderCommandTest::replayRefusesInWords_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::newRow("no output") << QStringList{"log.jsonl"} << 2;
    QTest::newRow("not a project") << QStringList{"log.jsonl", "-o", "y.png"} << 2;
    QTest::newRow("no steps") << QStringList{"log.jsonl", "-o", "y.ductus", "--steps", "0"} << 2;
    QTest::newRow("no such log") << QStringList{"none.jsonl", "-o", "y.ductus"} << 1;
    QTest::newRow("no log") << QStringList{"bad.jsonl", "-o", "y.ductus"} << 1;
}

void RenderCommandTest::replayRefusesInWords()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFile bad(file("bad.jsonl"));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write("{\"action\": \"fly\"}\n");
    bad.close();
    const QString before = QDir::currentPath();
    QDir::setCurrent(mFolder.path());
    const int found = int(runReplayCommand(arguments));
    QDir::setCurrent(before);
    QCOMPARE(found, code);
    QVERIFY(!QFile::exists(file("y.ductus")));
}

QTEST_GUILESS_MAIN(RenderCommandTest)
#include "render_command_test.moc"
