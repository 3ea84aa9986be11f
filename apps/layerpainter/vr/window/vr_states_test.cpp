// What a headset's software may do to us, and what may be missing.
#include "document/document_files.h"
#include "layerpainter/vr/testing/headset_under_test.h"

#include <malloc.h>

using namespace ductus;

namespace {

int strokes(const HeadsetUnderTest &test)
{
    return test.painting().stacks.back().substrate->elementCount();
}

// Pulls the trigger and moves; the stroke is not done.
void beginStroke(HeadsetUnderTest &test)
{
    test.put("right", {0.5, 1.1, -0.6});
    test.frames();
    test.input(test.trigger(), 0.9);
    test.frames();
    test.put("right", {0.5, 1.4, -0.6});
    test.frames();
}

} // namespace

class VrStatesTest : public QObject
{
    Q_OBJECT
private slots:
    void whatIsMissingIsSaid_data();
    void whatIsMissingIsSaid();
    void losingTheFocusEndsTheStroke();
    void stoppingPausesAndGoesOn();
    void aLostConnectionLosesNothing_data();
    void aLostConnectionLosesNothing();
    void aFailedCallEndsVrWithWords();
    void framesGoOnWhileSaving();
    void manyFramesTakeNoMoreMemory();
};

void VrStatesTest::whatIsMissingIsSaid_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("words");
    QTest::newRow("no runtime") << ""
                                << "no headset software";
    QTest::newRow("no headset") << "headset 0"
                                << "no headset is connected";
    QTest::newRow("no OpenGL") << "extensions none"
                               << "XR_KHR_opengl_enable";
    QTest::newRow("no formats") << "formats 0x8CAC"
                                << "no kind of image";
    QTest::newRow("in use") << "fail xrCreateSession -10"
                            << "another program";
}

void VrStatesTest::whatIsMissingIsSaid()
{
    QFETCH(QString, line);
    QFETCH(QString, words);
    HeadsetUnderTest test({line});
    if (line.isEmpty()) {
        qunsetenv("XR_RUNTIME_JSON");
        qputenv("XDG_CONFIG_HOME", test.folder.path().toUtf8());
        qputenv("XDG_CONFIG_DIRS", test.folder.path().toUtf8());
    }
    test.window->newPainting();
    const Result<void> started = test.vr().start();
    QVERIFY(!started.ok());
    const QString message = QString::fromStdString(started.error().message());
    QVERIFY2(message.contains(words), qPrintable(message));
    QVERIFY(!started.error().remedy.empty());
    QVERIFY(!test.vr().isActive());
    if (line == "extensions none") {
        // The loader keeps a runtime's extensions until an instance was tried: not for the next test.
        QFile::remove(test.folder.filePath("script"));
        (void)test.vr().start();
    }
    // The window goes on.
    QVERIFY(test.window->painting().perform(act::AddStack{"more", -1}).ok());
    const int before = test.window->view().frameCount();
    QVERIFY(test.wait([&] { return test.window->view().frameCount() > before; }));
}

void VrStatesTest::losingTheFocusEndsTheStroke()
{
    HeadsetUnderTest test;
    test.window->newPainting();
    QVERIFY(test.enter());
    beginStroke(test);
    QVERIFY(test.vr().tools().isPainting());
    test.say({"state visible"});
    QVERIFY(test.wait([&] { return test.vr().state() == XR_SESSION_STATE_VISIBLE; }));
    test.frames();
    QVERIFY(!test.vr().tools().isPainting());
    QCOMPARE(strokes(test), 1);
    QVERIFY(!test.record("frame").last().contains("layers 0")); // still shown, without hands
    test.say({"state synchronized"});
    QVERIFY(test.wait([&] { return test.vr().state() == XR_SESSION_STATE_SYNCHRONIZED; }));
    test.frames();
    QVERIFY(test.record("frame").last().contains("layers 0"));
    test.say({"state focused"});
    QVERIFY(test.wait([&] { return test.vr().state() == XR_SESSION_STATE_FOCUSED; }));
    test.frames(); // the trigger is still down: nothing is painted until it was let go of
    QVERIFY(!test.vr().tools().isPainting());
    test.input(test.trigger(), 0);
    test.frames();
    beginStroke(test);
    QVERIFY(test.vr().tools().isPainting());
    test.input(test.trigger(), 0);
    test.frames();
    QCOMPARE(strokes(test), 2);
    QCOMPARE(test.record("error"), QStringList());
    QCOMPARE(test.complaints(), QString());
}

void VrStatesTest::stoppingPausesAndGoesOn()
{
    HeadsetUnderTest test;
    test.window->newPainting();
    QVERIFY(test.enter());
    beginStroke(test);
    test.say({"state stopping"});
    QVERIFY(test.wait([&] { return test.vr().state() == XR_SESSION_STATE_IDLE; }));
    QCOMPARE(strokes(test), 1);
    QVERIFY(test.vr().isActive());
    test.say({"state ready"});
    QVERIFY(test.wait([&] { return test.vr().state() == XR_SESSION_STATE_FOCUSED; }));
    QVERIFY(test.frames());
    test.say({"state exiting"});
    QVERIFY(test.wait([&] { return test.endings == 1; }));
    QCOMPARE(test.ended, QString());
    QCOMPARE(test.record("error"), QStringList());
    QCOMPARE(test.complaints(), QString());
    const QStringList states = test.record("state ");
    QCOMPARE(states.mid(states.size() - 5),
             QStringList({"state 4", "state 3", "state 6", "state 1", "state 8"}));
}

void VrStatesTest::aLostConnectionLosesNothing_data()
{
    QTest::addColumn<QString>("line");
    QTest::newRow("session") << "lose session";
    QTest::newRow("instance") << "lose instance";
    QTest::newRow("session, at once") << "fail xrWaitFrame -17";
    QTest::newRow("instance, at once") << "fail xrEndFrame -13";
}

void VrStatesTest::aLostConnectionLosesNothing()
{
    QFETCH(QString, line);
    HeadsetUnderTest test;
    test.window->newPainting();
    QVERIFY(test.enter());
    beginStroke(test);
    test.say({line});
    QVERIFY(test.wait([&] { return test.endings == 1; }));
    QVERIFY2(test.ended.contains("headset"), qPrintable(test.ended));
    QCOMPARE(strokes(test), 1);
    QVERIFY(!test.vr().isActive());
    QCOMPARE(test.record("error"), QStringList());
    // And again, from the beginning: the script is read anew.
    QFile::remove(test.folder.filePath("script"));
    QVERIFY(test.enter());
    QVERIFY(test.frames());
}

void VrStatesTest::aFailedCallEndsVrWithWords()
{
    HeadsetUnderTest test;
    test.window->newPainting();
    QVERIFY(test.enter());
    test.say({"fail xrLocateViews -2"});
    QVERIFY(test.wait([&] { return test.endings == 1; }));
    QVERIFY2(test.ended.contains("XR_ERROR_RUNTIME_FAILURE") && test.ended.contains("xrLocateViews"),
             qPrintable(test.ended));
}

void VrStatesTest::framesGoOnWhileSaving()
{
    HeadsetUnderTest test({"size 32 32", "tracked left 0", "tracked right 0", "pace 5"});
    test.window->newPainting();
    StrokeShape stroke;
    for (int i = 0; i < 400; ++i)
        stroke.points.push_back({Eigen::Vector3f(0.001f * float(i), std::sin(0.1f * float(i)), 5), // behind
                                 Eigen::Vector3f::UnitY(), 0.01f, Eigen::Vector3f(1, 0, 0), 1});
    act::Draw draw{test.window->brush().layer, 0, {}, {}};
    for (int i = 0; i < 3000; ++i) {
        stroke.points.front().position.z() = 5 + 0.001f * float(i); // each its own bytes
        draw.strokes.push_back(std::make_shared<const ElementShape>(stroke));
    }
    QVERIFY(test.window->painting().perform(draw).ok());
    QVERIFY(test.enter());
    QVERIFY(test.frames(5));
    (void)test.vr().takeLongestGapMilliseconds();
    const int before = test.vr().frameCount();
    bool isDone = false;
    QElapsedTimer clock;
    clock.start();
    saveDocument(test.window->painting(), test.jobs, test.folder.filePath("large.ductus"),
                 [&](Result<SaveReport> saved) { isDone = saved.ok(); });
    QVERIFY(test.wait([&] { return isDone; }));
    const double saving = double(clock.nsecsElapsed()) * 1e-6, gap = test.vr().takeLongestGapMilliseconds();
    const int frames = test.vr().frameCount() - before;
    qInfo("saving took %.0f ms, meanwhile %d frames, the longest gap %.0f ms", saving, frames, gap);
    QVERIFY(frames >= 2);
    QVERIFY2(gap < 0.5 * saving || gap < 60, qPrintable(QString("%1 of %2").arg(gap).arg(saving)));
}

void VrStatesTest::manyFramesTakeNoMoreMemory()
{
    const int count = qEnvironmentVariableIntValue("DUCTUS_VR_FRAMES");
    const int frames = count > 0 ? count : 400;
    HeadsetUnderTest test({"size 16 16"});
    test.window->newPainting();
    QVERIFY(test.enter());
    QVERIFY(test.frames(100));
    const auto before = mallinfo2().uordblks;
    const int goal = test.vr().frameCount() + frames;
    QVERIFY(QTest::qWaitFor([&] { return test.vr().frameCount() >= goal; }, 2'000'000));
    const auto after = mallinfo2().uordblks;
    const double growth = double(after) - double(before);
    qInfo("%d frames: %.0f bytes more", frames, growth);
    QVERIFY2(growth < 200'000, qPrintable(QString::number(growth)));
}

QTEST_MAIN(VrStatesTest)
#include "vr_states_test.moc"
