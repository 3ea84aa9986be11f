// "The program was killed in the middle of my drawing": what was drawn is offered at the next start, with its
// clip. The killed program is this test, started anew with another argument.
#include "doodlestudio/ui/testing/studio_under_test.h"
#include "support/clip_scenes.h"
#include "widgets/pages/recovery_notice.h"

#include <QProcess>
#include <QPushButton>
#include <csignal>

using namespace ductus;

namespace {

const QString dieArgument = QStringLiteral("--draw-and-die");
constexpr int waitMs = 60'000;

std::vector<Image> film()
{
    const ClipScene scene = tripodScene(96, 54, 6);
    std::vector<Image> frames;
    for (int t = 0; t < scene.frameCount; ++t)
        frames.push_back(renderedImage(scene, t));
    return frames;
}

bool begin(StudioUnderTest &app, const QString &clip)
{
    if (!QTest::qWaitForWindowExposed(app.window.get()) || !app.open(clip))
        return false;
    app.jobs.cancelKey("analyse");
    if (!app.jobs.waitForAll(waitMs))
        return false;
    app.press(Qt::Key_3);
    return true;
}

const std::vector<Vec2> firstLine = {{20, 15}, {40, 20}, {60, 25}};
const std::vector<Vec2> secondLine = {{22, 25}, {30, 28}, {45, 30}};

// Draws two lines, waits for the copy that is kept by itself, and dies while a third one is drawn.
int drawAndDie(const QString &clip)
{
    StudioUnderTest app;
    if (!begin(app, clip))
        return 3;
    Autosave &autosave = app.window->unsavedWork().autosave();
    autosave.setTimes({50, 20, waitMs, 60});
    app.dragOnPicture(firstLine);
    app.dragOnPicture(secondLine);
    if (!QTest::qWaitFor([&] { return autosave.savedRevision() == app.window->doodle().revision(); }, waitMs))
        return 4;
    const QPoint at = app.window->player().mapTo(app.window.get(), app.window->player().rect().center());
    QTest::mousePress(app.window->windowHandle(), Qt::LeftButton, {}, at);
    QTest::mouseMove(app.window->windowHandle(), at + QPoint(30, 10));
    return std::raise(SIGKILL);
}

} // namespace

class RecoveryTest : public QObject
{
    Q_OBJECT
private slots:
    void killedWorkIsOfferedWithItsClip();
    void copiesWaitForTheEndOfALine();
};

void RecoveryTest::killedWorkIsOfferedWithItsClip()
{
    QTemporaryDir folder;
    const QString clip = folder.filePath("clip.mp4");
    writeClip(film(), clip, 12.0);
    qputenv("DUCTUS_STATE", folder.filePath("state").toUtf8());
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedChannels);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("TMPDIR", folder.path()); // what it leaves behind goes with the folder
    program.setProcessEnvironment(environment);
    program.start(QCoreApplication::applicationFilePath(), {dieArgument, clip});
    QVERIFY(program.waitForFinished(2 * waitMs));
    QCOMPARE(program.exitStatus(), QProcess::CrashExit);

    StudioUnderTest app;
    qunsetenv("DUCTUS_STATE");
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    QPushButton *open = nullptr;
    QVERIFY(QTest::qWaitFor(
        [&] {
            for (auto *notice : app.window->findChildren<RecoveryNotice *>())
                for (QPushButton *button : notice->findChildren<QPushButton *>())
                    if (button->text() == QLatin1String("Open") && button->isVisible())
                        open = button;
            return open != nullptr;
        },
        waitMs));
    app.shot("recovery");
    QSignalSpy shown(app.window.get(), &StudioWindow::clipShown);
    QTest::mouseClick(open, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return !shown.isEmpty(); }, waitMs));
    app.jobs.cancelKey("analyse");
    const DoodleDocument &doodle = app.window->doodle();
    QCOMPARE(doodle.clipPath(), clip);
    QVERIFY(doodle.isModified());
    QCOMPARE(doodle.scene().canvases.size(), std::size_t(1));
    QCOMPARE(doodle.scene().canvases[0].doodle.frames[0].marks.size(), std::size_t(2));
}

void RecoveryTest::copiesWaitForTheEndOfALine()
{
    StudioUnderTest app;
    const QString clip = app.folder.filePath("clip.mp4");
    writeClip(film(), clip, 12.0);
    QVERIFY(begin(app, clip));
    app.dragOnPicture(firstLine);
    Autosave &autosave = app.window->unsavedWork().autosave();
    const auto before = autosave.savedRevision();
    app.settle();
    const PlayerView &player = app.window->player();
    const auto place = [&](const Vec2 &working) {
        return player.mapTo(app.window.get(), player.toView(toPoint(working)).toPoint());
    };
    QWindow *handle = app.window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, place(secondLine[0]));
    QTest::mouseMove(handle, place(secondLine[1]));
    QVERIFY(app.window->player().isBusy());
    autosave.setTimes({20, 20, waitMs, 60});
    app.window->doodle().touch();
    QTest::qWait(300); // long past the time of the copy
    QCOMPARE(autosave.savedRevision(), before);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, place(secondLine[2]));
    QVERIFY(
        QTest::qWaitFor([&] { return autosave.savedRevision() == app.window->doodle().revision(); }, waitMs));
    QCOMPARE(app.window->doodle().scene().canvases[0].doodle.frames[0].marks.size(), std::size_t(2));
}

int main(int argc, char *argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    const QStringList arguments = application.arguments();
    if (arguments.size() == 3 && arguments[1] == dieArgument)
        return drawAndDie(arguments[2]);
    RecoveryTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "recovery_test.moc"
