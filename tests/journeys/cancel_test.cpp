// "I stopped it": Ctrl-C ends the program soon, says so, and leaves nothing behind.
#include "journeys/sketch_journey.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class CancelTest : public QObject
{
    Q_OBJECT
private slots:
    void ctrlCEndsItSoonAndLeavesNothing_data();
    void ctrlCEndsItSoonAndLeavesNothing();
    void previousResultIsKept();
};

void CancelTest::ctrlCEndsItSoonAndLeavesNothing_data()
{
    QTest::addColumn<QByteArray>("progress");
    // One of each stage, as the progress names them.
    for (const char *text : {"Reading the sketch", "Fitting a smooth surface", "Evening out the triangles",
                             "Finding surface patches", "Fitting the final mesh"})
        QTest::newRow(text) << QByteArray(text);
}

void CancelTest::ctrlCEndsItSoonAndLeavesNothing()
{
    QFETCH(QByteArray, progress);
    QTemporaryDir folder;
    // As long a job as a user starts.
    const QStringList arguments =
        surfaceArguments(samplePath("car"), folder.filePath("out.obj"),
                         {"--proxy-vertices", "12000", "--report", folder.filePath("out.json"), "--picture",
                          folder.filePath("out.png")});
    RunOptions options;
    options.timeoutSeconds = 120;
    options.signalAtProgress = progress;
    const ProgramRun run = runSketchSurfacer(arguments, options);
    QVERIFY2(run.secondsAfterSignal >= 0.0, run.told().constData());
    qInfo("ended %.2f s after Ctrl-C, %.2f s after the start", run.secondsAfterSignal, run.seconds);
    QVERIFY2(!run.crashed && !run.hung, run.told().constData());
    QCOMPARE(run.exitCode, 3);
    QVERIFY2(run.secondsAfterSignal <= 10.0, qPrintable(QString::number(run.secondsAfterSignal)));
    QVERIFY2(run.messages().size() == 1 && run.messages().first().contains("cancelled"),
             run.told().constData());
    QCOMPARE(namesBelow(folder.path()), QStringList());
}

void CancelTest::previousResultIsKept()
{
    QTemporaryDir folder;
    QVERIFY(writeBytes(folder.filePath("out.obj"), "the previous result"));
    RunOptions options;
    options.signalAtProgress = "Fitting a smooth surface";
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(samplePath("car"), folder.filePath("out.obj")), options);
    QVERIFY2(run.exitCode == 3, run.told().constData());
    QCOMPARE(bytesOf(folder.filePath("out.obj")), QByteArray("the previous result"));
    QCOMPARE(namesBelow(folder.path()), QStringList("out.obj"));
}

QTEST_GUILESS_MAIN(CancelTest)
#include "cancel_test.moc"
