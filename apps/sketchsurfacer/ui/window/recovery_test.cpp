// "The program was killed before I saved": the work is offered at the next start. The killed program is this
// test, started anew with another argument.
#include "sketchsurfacer/ui/window/surfacer_window.h"

#include "document/recovery/state_folder.h"
#include "widgets/pages/recovery_notice.h"

#include <QApplication>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

using namespace ductus;

namespace {

const QString dieArgument = QStringLiteral("--edit-and-die");
constexpr int waitMs = 30'000;

struct App
{
    Settings settings;
    JobRunner jobs;
    ActionCatalogue actions{&settings};
    SurfacerWindow window{{&settings, &jobs, &actions}};

    explicit App(const QString &folder) : settings(folder + QStringLiteral("/settings.ini"))
    {
        window.resize(1000, 700);
        window.show();
    }
    bool open(const QString &sample)
    {
        window.openSample(sample);
        return QTest::qWaitFor([&] { return !window.sketch().isEmpty(); }, waitMs) &&
               QTest::qWaitFor([&] { return window.view().frameCount() > 0; }, waitMs);
    }
    bool copyNow()
    {
        QSignalSpy saved(&window.unsavedWork().autosave(), &Autosave::saved);
        window.unsavedWork().autosave().saveNow();
        return saved.wait(waitMs);
    }
    QPushButton *noticeButton(const QString &text)
    {
        QPushButton *found = nullptr;
        QTest::qWaitFor(
            [&] {
                for (auto *notice : window.findChildren<RecoveryNotice *>())
                    for (QPushButton *button : notice->findChildren<QPushButton *>())
                        if (button->text() == text && button->isVisible())
                            found = button;
                return found != nullptr;
            },
            waitMs);
        return found;
    }
};

Scribble merge()
{
    Scribble scribble;
    scribble.kind = ScribbleKind::Merge;
    scribble.points = {Vec3(0.125, 0.25, 0.5), Vec3(0.25, 0.25, 0.5)};
    return scribble;
}

void edit(SketchDocument &sketch)
{
    sketch.addScribble(merge());
    sketch.addStroke({Vec3(0.0, 0.0, 0.0), Vec3(0.5, 0.25, 0.0), Vec3(1.0, 0.25, 0.125)});
}

int editAndDie(const QString &folder)
{
    App app(folder);
    if (!app.open(QStringLiteral("bottle")))
        return 3;
    edit(app.window.sketch());
    if (!app.copyNow())
        return 4;
    return std::raise(SIGKILL);
}

QStringList copies()
{
    return QDir(stateFolder(QStringLiteral("sketchsurfacer"), QStringLiteral("autosave")))
        .entryList(QDir::Files);
}

} // namespace

class RecoveryTest : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void killedWorkIsOfferedAndOpens();
    void whatIsDiscardedIsGone();
    void closingWithoutSavingLeavesNothing();
    void aResultAloneIsCopiedToo();

private:
    bool killAProgram();
    std::unique_ptr<QTemporaryDir> mFolder;
};

void RecoveryTest::init()
{
    mFolder = std::make_unique<QTemporaryDir>();
    qputenv("XDG_STATE_HOME", mFolder->filePath("state").toUtf8());
}

bool RecoveryTest::killAProgram()
{
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedChannels);
    program.start(QCoreApplication::applicationFilePath(), {dieArgument, mFolder->path()});
    return program.waitForFinished(2 * waitMs) && program.exitStatus() == QProcess::CrashExit;
}

void RecoveryTest::killedWorkIsOfferedAndOpens()
{
    QVERIFY(killAProgram());
    QVERIFY(!copies().isEmpty());
    App app(mFolder->path());
    QVERIFY(app.window.isStartPageShown());
    QPushButton *open = app.noticeButton("Open");
    QVERIFY(open);
    if (qEnvironmentVariableIsSet("DUCTUS_SHOTS")) {
        QTest::qWait(3000);
        app.window.grab().save(qEnvironmentVariable("DUCTUS_SHOTS") + "/recovery.png");
    }
    QTest::mouseClick(open, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!app.window.sketch().isEmpty(), waitMs);
    const SketchDocument &sketch = app.window.sketch();
    QVERIFY(!app.window.isStartPageShown());
    QVERIFY(sketch.isModified() && sketch.filePath().isEmpty());
    QVERIFY2(sketch.displayName().contains("bottle", Qt::CaseInsensitive), qPrintable(sketch.displayName()));

    App other(mFolder->path());
    QVERIFY(other.open("bottle"));
    edit(other.window.sketch());
    QCOMPARE(sketch.strokes().strokes.size(), other.window.sketch().strokes().strokes.size());
    for (std::size_t i = 0; i < sketch.strokes().strokes.size(); ++i)
        QVERIFY(sketch.strokes().strokes[i].points == other.window.sketch().strokes().strokes[i].points);
    QVERIFY(sketch.content().scribbles == std::vector<Scribble>{merge()});

    // The old copy is replaced by one that is held: nobody is offered what is being worked on.
    const QString folder = stateFolder("sketchsurfacer", "autosave");
    QTRY_COMPARE(QDir(folder).entryList({"*.ductus"}, QDir::Files).size(), 1);
    QTRY_COMPARE(app.window.unsavedWork().autosave().savedRevision(), sketch.revision());
    QVERIFY(QFile::exists(app.window.unsavedWork().autosave().copyPath()));
    QVERIFY(recoveredFiles(folder).isEmpty());
}

void RecoveryTest::whatIsDiscardedIsGone()
{
    QVERIFY(killAProgram());
    App app(mFolder->path());
    QPushButton *discard = app.noticeButton("Discard");
    QVERIFY(discard);
    QTest::mouseClick(discard, Qt::LeftButton);
    QCOMPARE(copies(), QStringList());
    QTRY_VERIFY(app.window.findChildren<RecoveryNotice *>().isEmpty());
}

void RecoveryTest::closingWithoutSavingLeavesNothing()
{
    {
        App app(mFolder->path());
        QVERIFY(app.open("bottle"));
        edit(app.window.sketch());
        QVERIFY(app.copyNow());
        QVERIFY(!copies().isEmpty());
        edit(app.window.sketch());
        app.window.unsavedWork().autosave().saveNow(); // being written while the window closes
        QTimer::singleShot(200, [] {
            auto *question = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
            QVERIFY(question);
            for (QAbstractButton *button : question->buttons())
                if (question->buttonRole(button) == QMessageBox::DestructiveRole)
                    button->click();
        });
        QVERIFY(app.window.close());
    }
    QCOMPARE(copies(), QStringList());
}

// Work of minutes, but no command of the history.
void RecoveryTest::aResultAloneIsCopiedToo()
{
    App app(mFolder->path());
    QVERIFY(app.open("bottle"));
    edit(app.window.sketch());
    Autosave &autosave = app.window.unsavedWork().autosave();
    autosave.setTimes({30, 20, 200, 60});
    QTRY_COMPARE(autosave.savedRevision(), app.window.sketch().revision());
    app.window.sketch().setResult(app.window.sketch().content(), std::make_shared<SurfacingState>());
    QVERIFY(autosave.savedRevision() != app.window.sketch().revision());
    QTRY_COMPARE(autosave.savedRevision(), app.window.sketch().revision());
}

int main(int argc, char *argv[])
{
    QApplication application(argc, argv);
    application.setApplicationName("sketchsurfacer");
    QStandardPaths::setTestModeEnabled(true);
    const QStringList arguments = application.arguments();
    if (arguments.size() == 3 && arguments[1] == dieArgument)
        return editAndDie(arguments[2]);
    RecoveryTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "recovery_test.moc"
