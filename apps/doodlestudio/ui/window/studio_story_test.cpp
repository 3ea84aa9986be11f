// The window by keyboard: playing, stepping, tools, and a canvas made by drawing on the picture, taken back.
#include "document/document_files.h"
#include "doodlestudio/ui/canvases/canvas_panel.h"
#include "doodlestudio/ui/film/export_dialog.h"
#include "doodlestudio/ui/testing/studio_under_test.h"

#include "doodlestudio/ui/timeline/transport_bar.h"
#include "support/clip_scenes.h"
#include "widgets/shell/message_bar.h"

#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

using namespace ductus;

namespace {

std::vector<Image> filmOf(const ClipScene &scene)
{
    std::vector<Image> frames;
    for (int t = 0; t < scene.frameCount; ++t)
        frames.push_back(renderedImage(scene, t));
    return frames;
}

} // namespace

class StudioStoryTest : public QObject
{
    Q_OBJECT
private slots:
    void everythingByKeyboard();
};

void StudioStoryTest::everythingByKeyboard()
{
    StudioUnderTest app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    const QString clip = app.folder.filePath("tripod.mp4");
    writeClip(filmOf(tripodScene(160, 90, 12)), clip, 12.0);
    QVERIFY(app.open(clip));
    app.jobs.cancelKey("analyse");
    Playback &playback = app.window->playback();
    app.press(Qt::Key_Right);
    app.press(Qt::Key_Period);
    QCOMPARE(playback.frame(), 2);
    app.press(Qt::Key_Comma);
    QCOMPARE(playback.frame(), 1);
    app.press(Qt::Key_End);
    QCOMPARE(playback.frame(), 11);
    app.press(Qt::Key_Home);
    QCOMPARE(playback.frame(), 0);
    app.press(Qt::Key_Space);
    QVERIFY(playback.isPlaying());
    QVERIFY(QTest::qWaitFor([&] { return playback.frame() >= 3; }, 5000));
    app.press(Qt::Key_K);
    QVERIFY(!playback.isPlaying());
    app.press(Qt::Key_J);
    QCOMPARE(playback.rate(), -1.0);
    app.press(Qt::Key_L);
    app.press(Qt::Key_L);
    QCOMPARE(playback.rate(), 2.0);
    app.press(Qt::Key_Space);
    // Steps, and the pen's width.
    app.press(Qt::Key_3);
    QCOMPARE(app.window->step(), StudioStep::Draw);
    const double width = app.window->state().brush().width;
    app.press(Qt::Key_BracketRight);
    QVERIFY(app.window->state().brush().width > width);
    app.press(Qt::Key_BracketLeft);
    QVERIFY(std::abs(app.window->state().brush().width - width) < 1e-12);
    app.press(Qt::Key_E);
    QVERIFY(app.window->state().brush().tool == DrawingTool::Eraser);
    // A canvas made by drawing on the picture is taken back and brought again.
    app.press(Qt::Key_P);
    app.dragOnPicture({{40, 40}, {60, 45}, {80, 50}});
    QCOMPARE(app.window->doodle().scene().canvases.size(), std::size_t(1));
    QCOMPARE(app.window->doodle().scene().canvases[0].doodle.frames[0].marks.size(), std::size_t(1));
    app.press(Qt::Key_Z, Qt::ControlModifier);
    app.press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(app.window->doodle().scene().canvases.empty());
}

int main(int argc, char *argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    StudioStoryTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "studio_story_test.moc"
