// Journeys through the window with real mouse and key events. With DUCTUS_SHOTS naming a folder each step
// leaves a picture there.
#include "sketchsurfacer/ui/testing/app_under_test.h"

#include "widgets/controls/segmented_switch.h"
#include "widgets/shell/message_bar.h"
#include "widgets/testing/keyboard_walk.h"
#include "widgets/theme/theme.h"

#include <QPushButton>
#include <QtTest>

using namespace ductus;
using namespace ductus::testing;

class SurfacerWindowTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void theStartPageLeadsIntoASample();
    void surfacesASampleWithoutHoldingUpTheWindow();
    void aGreenScribbleMergesAndUndoRestoresExactly();
    void aYellowScribbleMakesARegion();
    void escapeCancelsAndKeepsTheLastSurface();
    void keepsEverythingInTheProject();
    void worksByKeyboardAlone();
    void saysWhatIsWrongWithAFile();
    void paintsRolesInOneStep();
    void drawsStrokesAndTakesThemBack();

private:
    std::unique_ptr<App> mApp; // surfaced once: solving is what takes long
};

void SurfacerWindowTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
}

void SurfacerWindowTest::theStartPageLeadsIntoASample()
{
    QVERIFY(mApp->window->isStartPageShown());
    QTest::qWait(qEnvironmentVariableIsSet("DUCTUS_SHOTS") ? 4000 : 0);
    mApp->shot("01-start");
    QVERIFY(mApp->open("bevelled-box"));
    QVERIFY(!mApp->window->isStartPageShown());
    QVERIFY(mApp->window->sketch().strokes().strokes.size() > 20);
    QCOMPARE(mApp->window->view().mode(), ViewMode::Sketch);
    QTRY_VERIFY(mApp->window->view().frameCount() > 0);
    mApp->shot("02-sketch");
}

void SurfacerWindowTest::surfacesASampleWithoutHoldingUpTheWindow()
{
    auto *button = mApp->window->findChild<QPushButton *>("surfaceButton");
    QVERIFY(button && button->isEnabled());
    bool sawPreview = false;
    const auto watch = connect(&mApp->window->presenter(), &SketchPresenter::resultShown, this, [&] {
        sawPreview = sawPreview || mApp->window->presenter().resultView()->isPreview;
    });
    {
        Heartbeat heart;
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(mApp->window->surfacing().isRunning());
        QVERIFY(mApp->waitForResult());
        qInfo("longest pause of the event loop: %lld ms, of which this thread worked at most %.0f ms; a "
              "frame takes %.0f ms",
              heart.longestMilliseconds(), heart.mostWorkMilliseconds(),
              mApp->window->view().lastFrameMilliseconds());
        QVERIFY2(heart.mostWorkMilliseconds() <= 100.0,
                 qPrintable(QString::number(heart.mostWorkMilliseconds())));
    }
    disconnect(watch);
    QVERIFY2(sawPreview, "the regions are shown before the final mesh");
    QVERIFY(mApp->surface().triangleCount() > 1000);
    QCOMPARE(mApp->window->view().mode(), ViewMode::Surface);
    mApp->shot("04-surface");
    for (const auto &[key, name] :
         {std::pair(Qt::Key_2, "05-proxy"), {Qt::Key_3, "06-regions"}, {Qt::Key_5, "07-deviation"}}) {
        mApp->press(key);
        QTRY_COMPARE(int(mApp->window->view().mode()), int(key) - int(Qt::Key_1));
        mApp->shot(name);
    }
}

void SurfacerWindowTest::aGreenScribbleMergesAndUndoRestoresExactly()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_3);
    mApp->press(Qt::Key_M);
    QCOMPARE(window.tools().tool(), ToolKind::Merge);
    const std::vector<QPoint> line = mApp->acrossRegions();
    QVERIFY(!line.empty());
    const TriangleMesh before = mApp->surface();
    const std::size_t regionsBefore = window.sketch().result()->surface->regions.size();

    QElapsedTimer clock;
    clock.start();
    mApp->drag(line);
    QCOMPARE(window.sketch().content().scribbles.size(), std::size_t(1));
    QVERIFY(mApp->waitForResult());
    qInfo("from the scribble to the final mesh shown: %lld ms", clock.elapsed());
    mApp->shot("08-merged");
    QVERIFY(window.sketch().result()->surface->regions.size() < regionsBefore);
    QCOMPARE(mApp->regionAt(line.front()), mApp->regionAt(line.back()));
    const TriangleMesh after = mApp->surface();

    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.sketch().isUpToDate()); // at once, nothing is solved
    QVERIFY(sameMesh(mApp->surface(), before));
    QVERIFY(window.sketch().content().scribbles.empty());
    mApp->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(window.sketch().isUpToDate());
    QVERIFY(sameMesh(mApp->surface(), after));
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(sameMesh(mApp->surface(), before));
}

// What was merged too far is taken apart again.
void SurfacerWindowTest::aYellowScribbleMakesARegion()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_3);
    const std::vector<QPoint> across = mApp->acrossRegions();
    QVERIFY(!across.empty());
    const auto view = window.presenter().resultView();
    const Vec3 inside = view->regionViews[std::size_t(mApp->regionAt(across.back()))].inside;
    const QPoint end = window.view().camera().project(inside)->toPoint();
    QCOMPARE(mApp->regionAt(end), mApp->regionAt(across.back()));
    mApp->press(Qt::Key_M);
    mApp->drag(across);
    QVERIFY(mApp->waitForResult());
    const std::size_t merged = window.sketch().result()->surface->regions.size();
    QCOMPARE(mApp->regionAt(across.front()), mApp->regionAt(end));

    mApp->press(Qt::Key_N);
    QCOMPARE(window.tools().tool(), ToolKind::NewRegion);
    mApp->drag({end - QPoint(60, 0), end - QPoint(30, 8), end, end + QPoint(30, 8), end + QPoint(60, 0)});
    QVERIFY(mApp->waitForResult());
    mApp->shot("09-new-region");
    QCOMPARE(window.sketch().content().scribbles.size(), std::size_t(2));
    QCOMPARE(window.sketch().content().scribbles.back().kind, ScribbleKind::NewRegion);
    QVERIFY(window.sketch().result()->surface->regions.size() > merged);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.sketch().isUpToDate());
}

void SurfacerWindowTest::escapeCancelsAndKeepsTheLastSurface()
{
    SurfacerWindow &window = *mApp->window;
    const TriangleMesh before = mApp->surface();
    SurfaceOptions options = window.sketch().content().options;
    options.segmentation.epsilon = 0.02;
    options.proxy.wrap.tightness = 0.4; // from the beginning: long enough to be stopped
    window.sketch().setOptions("Change looseness", options);
    QTRY_VERIFY(window.surfacing().isRunning());
    QTest::qWait(50);
    mApp->shot("03-running");
    QVERIFY(window.surfacing().isRunning());
    mApp->press(Qt::Key_Escape);
    QTRY_VERIFY(!window.surfacing().isRunning());
    QVERIFY(!window.sketch().isUpToDate());
    QVERIFY(window.sketch().shownResult() && window.sketch().shownResult()->hasSurface());
    QVERIFY(sameMesh(window.sketch().shownResult()->surface->mesh, before));
    QVERIFY(window.messages()->messages().isEmpty());
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.sketch().isUpToDate());
}

void SurfacerWindowTest::keepsEverythingInTheProject()
{
    SurfacerWindow &window = *mApp->window;
    const TriangleMesh before = mApp->surface();
    const Project project = window.sketch().snapshot();
    SketchDocument reopened;
    QVERIFY(reopened.load(project, {}).ok());
    QCOMPARE(reopened.strokes().strokes.size(), window.sketch().strokes().strokes.size());
    QVERIFY(reopened.content().scribbles == window.sketch().content().scribbles);
    QVERIFY(reopened.result() && sameMesh(reopened.result()->surface->mesh, before));
    QVERIFY(!reopened.isModified());
}

void SurfacerWindowTest::worksByKeyboardAlone()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_V);
    QCOMPARE(window.tools().tool(), ToolKind::Select);
    const ViewCamera before = window.view().camera();
    mApp->press(Qt::Key_Right, Qt::AltModifier);
    QVERIFY(!(window.view().camera() == before));
    mApp->press(Qt::Key_F);
    mApp->press(Qt::Key_C);
    QVERIFY(window.view().comparison().has_value());
    mApp->press(Qt::Key_4);
    mApp->shot("10-compare");
    mApp->press(Qt::Key_C);
    QVERIFY(!window.view().comparison().has_value());
    mApp->press(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(window.presenter().selection().size(), window.sketch().strokes().strokes.size());
    mApp->press(Qt::Key_Escape);
    QVERIFY(window.presenter().selection().empty());
    const KeyboardWalk walk = walkByKeyboard(window);
    QVERIFY2(walk.problems.isEmpty(), qPrintable((walk.problems + walk.visited).join('\n')));
}

void SurfacerWindowTest::saysWhatIsWrongWithAFile()
{
    App app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    const QString path = app.dir.filePath("broken.curves");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 2\n0 0 0\n1 nan 0\n");
    file.close();
    app.window->openPath(path);
    QTRY_VERIFY(!app.window->messages()->messages().isEmpty());
    QCOMPARE(app.window->messages()->messages().last().kind, MessageKind::Error);
    QVERIFY(app.window->messages()->messages().last().what.contains("broken.curves"));
    QVERIFY(app.window->isStartPageShown());
    app.shot("11-error");
}

void SurfacerWindowTest::paintsRolesInOneStep()
{
    App app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    QVERIFY(app.open("computer-mouse"));
    QTRY_VERIFY(app.window->view().frameCount() > 0);
    app.press(Qt::Key_B);
    const int width = app.window->view().width(), y = app.window->view().height() / 2;
    std::vector<QPoint> line;
    for (int x = width / 4; x < 3 * width / 4; x += 6)
        line.push_back({x, y});
    app.drag(line);
    const auto isBoundary = [](const Stroke &stroke) { return stroke.role == StrokeRole::Boundary; };
    const auto &strokes = app.window->sketch().strokes().strokes;
    QVERIFY(std::count_if(strokes.begin(), strokes.end(), isBoundary) >= 2);
    app.shot("12-roles");
    QCOMPARE(app.window->sketch().undoStack()->count(), 1);
    app.press(Qt::Key_Z, Qt::ControlModifier);
    const auto &restored = app.window->sketch().strokes().strokes;
    QCOMPARE(std::count_if(restored.begin(), restored.end(), isBoundary), std::ptrdiff_t(0));
    app.window->sketch().undoStack()->setClean();
    setThemeChoice(app.settings, ThemeChoice::Light);
    app.shot("13-light-sketch");
}

void SurfacerWindowTest::drawsStrokesAndTakesThemBack()
{
    App app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    QVERIFY(app.open("bottle"));
    QTRY_VERIFY(app.window->view().frameCount() > 0);
    const std::size_t before = app.window->sketch().strokes().strokes.size();
    app.press(Qt::Key_D);
    app.drag({{300, 300}, {320, 310}, {340, 330}, {360, 360}});
    QCOMPARE(app.window->sketch().strokes().strokes.size(), before + 1);
    QVERIFY(app.window->sketch().strokes().strokes.back().points.size() >= 3);
    app.press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(app.window->sketch().strokes().strokes.size(), before);
}

QTEST_MAIN(SurfacerWindowTest)
#include "surfacer_window_test.moc"
