// "I have sketches from another program": drawn by people in VR and by others' tools. They become a sound
// mesh near the strokes, or it is said why not. The files are other people's and stand outside the
// repository.
#include "journeys/sketch_journey.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class RealSketchesTest : public QObject
{
    Q_OBJECT
private slots:
    void becomeASurfaceOrSayWhyNot_data();
    void becomeASurfaceOrSayWhyNot();
};

void RealSketchesTest::becomeASurfaceOrSayWhyNot_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("isAlwaysRun");
    for (const char *file : {"cassie/curves/hat.curves", "lines/car.obj"})
        QTest::newRow(file) << file << true;
    for (const char *file :
         {"cassie/curves/guitar.curves", "cassie/curves/chair.curves", "cassie/curves/computer-mouse.curves",
          "cassie/curves/vintage_car.curves", "cassie/curves/shield.curves", "lines/bulbasaur.obj",
          "lines/box.obj", "lines/guitar.obj", "lines/iron.obj", "lines/torus.obj"})
        QTest::newRow(file) << file << false;
}

void RealSketchesTest::becomeASurfaceOrSayWhyNot()
{
    QFETCH(QString, file);
    QFETCH(bool, isAlwaysRun);
    const QString in = QDir(DUCTUS_SHARED_DATA).filePath("sketches/" + file);
    if (!QFileInfo::exists(in))
        QSKIP("the folder with other people's sketches is not here");
    if (!isAlwaysRun && qEnvironmentVariable("DUCTUS_ALL_REAL") != QLatin1String("1"))
        QSKIP("takes long; set DUCTUS_ALL_REAL=1 to run it");
    QTemporaryDir folder;
    const QString out = folder.filePath("out.obj");
    const ProgramRun run = runSketchSurfacer(surfaceArguments(in, out, {"--proxy-vertices", "6000"}));
    QVERIFY2(!run.crashed && !run.hung, run.told().constData());
    qInfo("exit code %d after %.1f s; %s", run.exitCode, run.seconds,
          run.messages().isEmpty() ? "" : qPrintable(run.messages().last()));
    if (run.exitCode == 0) {
        const TriangleMesh mesh = meshOf(out);
        QCOMPARE(faultOfMesh(mesh), QString());
        QCOMPARE(faultOfFit(strokesOf(in), mesh, 0.5), QString());
    } else {
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.messages().last().contains("failed: "), run.told().constData());
        QCOMPARE(namesBelow(folder.path()), QStringList());
    }
}

QTEST_GUILESS_MAIN(RealSketchesTest)
#include "real_sketches_test.moc"
