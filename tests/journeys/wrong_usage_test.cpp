// "I mistyped the command": exit code 2 and a line that says what is expected; help is help and no error.
#include "journeys/sketch_journey.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class WrongUsageTest : public QObject
{
    Q_OBJECT
private slots:
    void saysWhatIsExpected_data();
    void saysWhatIsExpected();
    void helpIsNoError_data();
    void helpIsNoError();
    void helpNamesEveryOption();
};

void WrongUsageTest::saysWhatIsExpected_data()
{
    QTest::addColumn<QStringList>("arguments"); // IN and OUT stand for a good sketch and a good output
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, const char *arguments, const char *says) {
        QTest::newRow(name) << QString(arguments).split(' ', Qt::SkipEmptyParts) << QString(says);
    };
    row("nothing", "", "Usage:");
    row("unknown command", "surfaces IN -o OUT", "there is no command and no file \"surfaces\"");
    row("no sketch", "surface -o OUT", "no sketch was given");
    row("no output", "surface IN", "-o OUT is missing");
    row("output without value", "surface IN -o", "-o");
    row("unknown option", "surface IN -o OUT --smooth 3", "smooth");
    row("unknown output format", "surface IN -o out.docx", ".obj, .ply, .stl, .off, .glb or .ductus");
    row("output without extension", "surface IN -o out", ".obj, .ply, .stl, .off, .glb or .ductus");
    row("picture of another kind", "surface IN -o OUT --picture p.jpg", ".png");
    row("report onto output", "surface IN -o OUT --report OUT", "same file");
    row("report onto output, spelled differently", "surface IN -o out.obj --report ./out.obj", "same file");
    row("report onto picture", "surface IN -o OUT --report p.png --picture p.png", "same file");
    row("symmetry of four axes", "surface IN -o OUT --symmetry w", "--symmetry");
    row("symmetry without direction", "surface IN -o OUT --symmetry 0,0,0,1", "--symmetry");
    row("symmetry that is no number", "surface IN -o OUT --symmetry 0,nan,1,0", "--symmetry");
    row("symmetry of three numbers", "surface IN -o OUT --symmetry 0,0,1", "--symmetry");
    row("epsilon of zero", "surface IN -o OUT --epsilon 0", "--epsilon");
    row("epsilon with a comma", "surface IN -o OUT --epsilon 0,01", "--epsilon");
    row("epsilon nan", "surface IN -o OUT --epsilon nan", "--epsilon");
    row("no runs", "surface IN -o OUT --runs 0", "--runs");
    row("half a run", "surface IN -o OUT --runs 1.5", "--runs");
    row("negative seed", "surface IN -o OUT --seed=-1", "--seed");
    row("tightness above one", "surface IN -o OUT --tightness 2", "--tightness");
    row("proxy of three vertices", "surface IN -o OUT --proxy-vertices 3", "--proxy-vertices");
    row("stroke names", "surface IN -o OUT --boundary first", "--boundary");
    row("backward range", "surface IN -o OUT --boundary 7-3", "--boundary");
    row("open range", "surface IN -o OUT --ignore 7-", "--ignore");
    row("huge range", "surface IN -o OUT --ignore 0-2147483647", "--ignore");
    row("empty list", "surface IN -o OUT --ignore ,", "--ignore");
}

void WrongUsageTest::saysWhatIsExpected()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, says);
    QTemporaryDir folder;
    for (QString &argument : arguments)
        argument = argument == "IN"    ? samplePath("bent-leaf")
                   : argument == "OUT" ? QString("out.obj")
                                       : argument;
    RunOptions options;
    options.folder = folder.path();
    const ProgramRun run = runSketchSurfacer(arguments, options);
    QVERIFY2(!run.crashed && run.exitCode == 2, run.told().constData());
    QVERIFY2(run.err.contains(says), run.told().constData());
    QVERIFY2(arguments.isEmpty() || run.messages().first().startsWith("sketchsurfacer"),
             run.told().constData());
    QVERIFY2(run.err.contains("--help"), "it says where to read more");
    QCOMPARE(run.out, QString());
    QCOMPARE(namesBelow(folder.path()), QStringList());
    QVERIFY2(run.seconds < 10.0, "known before any work");
}

void WrongUsageTest::helpIsNoError_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("says");
    QTest::newRow("--help") << QStringList{"--help"} << "surface IN -o OUT";
    QTest::newRow("help") << QStringList{"help"} << "surface IN -o OUT";
    QTest::newRow("surface --help") << QStringList{"surface", "--help"} << "--symmetry";
    QTest::newRow("help beside other things") << QStringList{"surface", "x.curves", "-h"} << "--symmetry";
    QTest::newRow("--version") << QStringList{"--version"} << "SketchSurfacer ";
}

void WrongUsageTest::helpIsNoError()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, says);
    const ProgramRun run = runSketchSurfacer(arguments);
    QVERIFY2(run.exitCode == 0, run.told().constData());
    QVERIFY2(run.out.contains(says), run.told().constData());
    QCOMPARE(run.err, QString());
}

void WrongUsageTest::helpNamesEveryOption()
{
    const ProgramRun run = runSketchSurfacer({"surface", "--help"});
    for (const char *word : {"--output", "--proxy", "--symmetry", "--epsilon", "--simplicity", "--smoothness",
                             "--runs", "--seed", "--proxy-vertices", "--tightness", "--boundary", "--ignore",
                             "--report", "--picture", "--quiet", "Exit codes"})
        QVERIFY2(run.out.contains(word), word);
}

QTEST_GUILESS_MAIN(WrongUsageTest)
#include "wrong_usage_test.moc"
