// "I build a painting by a script": a log of actions becomes a project, its looks are drawn each for itself,
// and the same log gives the same bytes.
#include "formats/png_file.h"
#include "journeys/program_run.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class PaintScriptTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void becomesAPaintingWithTwoLooks();
    void givesTheSameBytes();
    void aWrongLineIsNamed();

private:
    static ProgramRun run(const QStringList &arguments)
    {
        return runProgram(QStringLiteral(DUCTUS_LAYERPAINTER), arguments);
    }
    // moc stumbles over raw strings: JSON is written with other quotes.
    static QByteArray json(QByteArray text) { return text.replace('\'', '"'); }
    static QByteArray stroke(const QByteArray &section, const QByteArray &width, const QByteArray &colour)
    {
        const auto point = [&](const QByteArray &x) {
            return "[" + x + ", 0, 0, 0, 0, 1, " + width + ", " + colour + ", 1]";
        };
        return "{'section': '" + section + "', 'points': [" + point("-1") + ", " + point("1") + "]}";
    }
    static QByteArray draw(const QByteArray &layer, const QByteArray &drawn, const QByteArray &made)
    {
        return "{'action': 'draw', 'objects': {'layer': " + layer + "}, 'parameters': {'strokes': [" + drawn +
               "]}, 'made': [" + made + "]}\n";
    }
    void write(const QString &name, const QByteArray &text)
    {
        QFile file(mFolder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    QTemporaryDir mFolder;
};

void PaintScriptTest::initTestCase()
{
    // A green bar, a red layer over its middle, and a second look without the red.
    write(
        "script.jsonl",
        json("{'action': 'addStack', 'objects': {}, 'parameters': {'name': 'bar'}, 'made': [1, 2]}\n" +
             draw("2", stroke("cube", "0.3", "0, 0.5, 0"), "3") +
             "{'action': 'addLayer', 'objects': {'stack': 1}, 'parameters': {'name': 'red'}, 'made': [4]}\n" +
             draw("4", stroke("round", "0.5", "1, 0, 0"), "5") +
             "{'action': 'addLook', 'objects': {}, 'parameters': {'name': 'with'}, 'made': [6]}\n"
             "{'action': 'setProperties', 'objects': {'layer': 4}, 'parameters': {'visible': false}}\n"
             "{'action': 'addLook', 'objects': {}, 'parameters': {'name': 'without'}, 'made': [7]}\n"));
}

void PaintScriptTest::becomesAPaintingWithTwoLooks()
{
    const QString project = mFolder.filePath("a.ductus");
    const ProgramRun replayed = run({"replay", mFolder.filePath("script.jsonl"), "-q", "-o", project});
    QVERIFY2(replayed.exitCode == 0, replayed.told().constData());
    QCOMPARE(run({"validate", project}).exitCode, 0);
    const ProgramRun drawn = run({"render", project, "-q", "-o", mFolder.filePath("l.png"), "--every-look",
                                  "--size", "64x40", "--camera", "0,0,5,0,0,0,40"});
    QVERIFY2(drawn.exitCode == 0, drawn.told().constData());
    const Result<Image> with = readPng(mFolder.filePath("l-with.png").toStdString()),
                        without = readPng(mFolder.filePath("l-without.png").toStdString());
    QVERIFY(with.ok() && without.ok());
    const auto middle = [](const Image &image) { return image.at(image.width / 2, image.height / 2); };
    QCOMPARE(int(middle(*with)[0]), 255);
    QCOMPARE(int(middle(*with)[1]), 0);
    QCOMPARE(int(middle(*without)[0]), 0);
    QVERIFY(std::abs(int(middle(*without)[1]) - 188) <= 1); // 0.5 in sRGB
}

void PaintScriptTest::givesTheSameBytes()
{
    QByteArray bytes[2];
    for (QByteArray &each : bytes) {
        const QString project = mFolder.filePath("b.ductus");
        QCOMPARE(run({"replay", mFolder.filePath("script.jsonl"), "-q", "-o", project}).exitCode, 0);
        QFile file(project);
        QVERIFY(file.open(QIODevice::ReadOnly));
        each = file.readAll();
    }
    QVERIFY(!bytes[0].isEmpty());
    QVERIFY(bytes[0] == bytes[1]);
}

void PaintScriptTest::aWrongLineIsNamed()
{
    QFile good(mFolder.filePath("script.jsonl"));
    QVERIFY(good.open(QIODevice::ReadOnly));
    write("bad.jsonl",
          good.readAll() + json("{'action': 'removeLayer', 'objects': {'layer': 99}, 'parameters': {}}\n"));
    const ProgramRun refused =
        run({"replay", mFolder.filePath("bad.jsonl"), "-q", "-o", mFolder.filePath("c.ductus")});
    QCOMPARE(refused.exitCode, 1);
    QVERIFY2(refused.err.contains("bad.jsonl") && refused.err.contains("8"), refused.told().constData());
    QVERIFY(!QFile::exists(mFolder.filePath("c.ductus")));
}

QTEST_GUILESS_MAIN(PaintScriptTest)
#include "paint_script_test.moc"
