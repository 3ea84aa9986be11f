// "It could not write": folders that are missing or protected, full disks, and files that must not be lost.
#include "journeys/sketch_journey.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class OutputPlaceTest : public QObject
{
    Q_OBJECT
private slots:
    void folderThatIsMissing();
    void folderIMayNotWriteTo();
    void fileThatIsProtected();
    void placeThatIsAFolder();
    void diskThatIsFull_data();
    void diskThatIsFull();
    void linkStaysALink();
    void paths_data();
    void paths();
};

namespace {

const auto everybody = QFile::Permissions(0x7777);
const auto readOnly = QFile::Permissions(0x5555);

} // namespace

void OutputPlaceTest::folderThatIsMissing()
{
    QTemporaryDir folder;
    const QString in = samplePath("bent-leaf"), good = folder.filePath("out.obj");
    const QString bad = folder.filePath("not/there");
    const QStringList commands[] = {surfaceArguments(in, bad + ".obj"),
                                    surfaceArguments(in, good, {"--report", bad + ".json"}),
                                    surfaceArguments(in, good, {"--picture", bad + ".png"})};
    for (const QStringList &arguments : commands) {
        const ProgramRun run = runSketchSurfacer(arguments);
        const QString fault = faultOfRefusal(run, {"not/there.", "folder does not exist"}, folder.path(), {});
        QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
        QVERIFY2(run.seconds < 10.0, "known before any work");
    }
}

void OutputPlaceTest::folderIMayNotWriteTo()
{
    if (!canRunWithoutRights())
        QSKIP("as root, with the program out of reach of the unprivileged user");
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("closed"));
    QVERIFY(QFile::setPermissions(folder.path(), everybody));
    QVERIFY(QFile::setPermissions(folder.filePath("closed"), readOnly));
    const QStringList before = namesBelow(folder.path());
    RunOptions options;
    options.withoutRights = true;
    options.folder = folder.path();
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(samplePath("bent-leaf"), folder.filePath("closed/out.obj")), options);
    const QString fault =
        faultOfRefusal(run, {"closed/out.obj", "may not be written"}, folder.path(), before);
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
    QVERIFY2(run.seconds < 10.0, "known before any work");
    QVERIFY(QFile::setPermissions(folder.filePath("closed"), everybody)); // or it cannot be removed
}

void OutputPlaceTest::fileThatIsProtected()
{
    if (!canRunWithoutRights())
        QSKIP("as root, with the program out of reach of the unprivileged user");
    QTemporaryDir folder;
    QVERIFY(QFile::setPermissions(folder.path(), everybody));
    QVERIFY(writeBytes(folder.filePath("out.obj"), "the one I like"));
    QVERIFY(QFile::setPermissions(folder.filePath("out.obj"), readOnly));
    RunOptions options;
    options.withoutRights = true;
    options.folder = folder.path();
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(samplePath("bent-leaf"), folder.filePath("out.obj")), options);
    const QString fault = faultOfRefusal(run, {"out.obj", "write-protected"}, folder.path(), {"out.obj"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
    QCOMPARE(bytesOf(folder.filePath("out.obj")), QByteArray("the one I like"));
}

void OutputPlaceTest::placeThatIsAFolder()
{
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("out.obj"));
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(samplePath("bent-leaf"), folder.filePath("out.obj")));
    const QString fault = faultOfRefusal(run, {"out.obj", "this is a folder"}, folder.path(), {"out.obj"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
}

void OutputPlaceTest::diskThatIsFull_data()
{
    QTest::addColumn<quint64>("bytes");
    QTest::addColumn<QString>("file");
    // The mesh takes about 200 KB, the report 3 KB, the picture some 300 KB.
    QTest::newRow("nothing fits") << quint64(0) << "out.json";
    QTest::newRow("the report fits") << quint64(20'000) << "out.png";
}

void OutputPlaceTest::diskThatIsFull()
{
    QFETCH(quint64, bytes);
    QFETCH(QString, file);
    QTemporaryDir folder;
    QVERIFY(writeBytes(folder.filePath("out.obj"), "the previous result"));
    RunOptions options;
    options.largestFileBytes = bytes;
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(samplePath("bent-leaf"), folder.filePath("out.obj"),
                         {"--report", folder.filePath("out.json"), "--picture", folder.filePath("out.png")}),
        options);
    const QString fault = faultOfRefusal(run, {file, "failed"}, folder.path(), {"out.obj"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
    QCOMPARE(bytesOf(folder.filePath("out.obj")), QByteArray("the previous result"));
}

void OutputPlaceTest::linkStaysALink()
{
    QTemporaryDir folder;
    QVERIFY(writeBytes(folder.filePath("real.obj"), "old"));
    QVERIFY(QFile::link(folder.filePath("real.obj"), folder.filePath("link.obj")));
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(samplePath("bent-leaf"), folder.filePath("link.obj")));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    QVERIFY(QFileInfo(folder.filePath("link.obj")).isSymLink());
    QCOMPARE(faultOfMesh(meshOf(folder.filePath("real.obj"))), QString());
    QCOMPARE(namesBelow(folder.path()), (QStringList{"link.obj", "real.obj"}));
}

void OutputPlaceTest::paths_data()
{
    QTest::addColumn<QString>("folderName");
    QTest::addColumn<QString>("stem");
    QTest::newRow("spaces") << "my  drawings"
                            << " a hat (2) ";
    QTest::newRow("German") << QString::fromUtf8("Entwürfe") << QString::fromUtf8("Süße Maus");
    QTest::newRow("Japanese") << QString::fromUtf8("スケッチ") << QString::fromUtf8("葉っぱ");
    QTest::newRow("Arabic and emoji") << QString::fromUtf8("رسم") << QString::fromUtf8("🍃\u200f leaf");
    QTest::newRow("quotes and percents") << "it's \"100 %s\" %n"
                                         << "a;b&c$HOME`x`";
    QTest::newRow("longest name") << "long" << QString(250, QLatin1Char('n'));
    QTest::newRow("begins with a dash") << "-o"
                                        << "-leaf";
}

void OutputPlaceTest::paths()
{
    QFETCH(QString, folderName);
    QFETCH(QString, stem);
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(folderName));
    const QDir inside(folder.filePath(folderName));
    const QString in = inside.filePath("in.curves"), out = inside.filePath(stem + ".obj");
    QVERIFY(QFile::copy(samplePath("bent-leaf"), in));
    const QString report = inside.filePath(QString("r") + folderName + ".json");
    const ProgramRun run = runSketchSurfacer(surfaceArguments(in, out, {"--report", report}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    QCOMPARE(faultOfMesh(meshOf(out)), QString());
    QVERIFY2(run.messages().last().contains(out), run.told().constData());
    QVERIFY(!bytesOf(report).isEmpty());
    QCOMPARE(namesBelow(inside.path()).size(), 3);
}

QTEST_GUILESS_MAIN(OutputPlaceTest)
#include "output_place_test.moc"
