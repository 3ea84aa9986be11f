#include "document/testing/note_document.h"
#include "widgets/controls/folding_section.h"
#include "widgets/main_window_shell.h"
#include "widgets/pages/settings_dialog.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/message_bar.h"
#include "widgets/shell/top_row.h"
#include "widgets/testing/keyboard_walk.h"
#include "widgets/testing/widget_test_main.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUrl>

using namespace ductus;

namespace {

struct Setup
{
    QTemporaryDir dir;
    Settings settings{dir.filePath("s.ini")};
    JobRunner jobs;
    ActionCatalogue actions{&settings};

    ShellServices services() { return {&settings, &jobs, &actions}; }
};

const AppIdentity identity{"SketchSurfacer", AppKind::SketchSurfacer, "app-sketchsurfacer"};

// Answers the next question about saving with the button whose text has \a word.
void answer(const QString &word, bool &wasAsked)
{
    QTimer::singleShot(50, [word, &wasAsked] {
        auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        if (!box)
            return;
        wasAsked = true;
        for (QAbstractButton *candidate : box->buttons()) {
            if (candidate->text().contains(word)) {
                candidate->click();
                return;
            }
        }
        box->reject();
    });
}

class LayoutRequests : public QObject
{
public:
    int count = 0;

    bool eventFilter(QObject *, QEvent *event) override
    {
        count += event->type() == QEvent::LayoutRequest;
        return false;
    }
};

} // namespace

class MainWindowShellTest : public QObject
{
    Q_OBJECT
private slots:
    void placesAreFilled();
    void undoFollowsTheDocument();
    void closingAsksOnlyWithUnsavedWork();
    void cancelKeepsTheWindow();
    void saveWritesBeforeClosing();
    void droppedFilesAreTold();
    void helpNamesTheTopic();
    void theWindowComesBackWhereItWas();
    void themeChangesAtOnce();
    void narrowRowsFoldTheirMenus();
    void narrowRowsComeToRest();
    void errorsAreShownCancelsAreNot();
    void everythingIsReachedByKeyboard();
};

void MainWindowShellTest::placesAreFilled()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    window.resize(1280, 800);
    window.show();
    QVERIFY(window.isStartPageShown());
    auto *canvas = new QWidget;
    auto *content = new QLabel("content");
    window.setCanvas(canvas);
    window.setCentre(new QLabel("centre"));
    window.addSection("shape", "Shape", content);
    auto *strip = new QLabel("strip");
    window.setStrip(strip);
    QVERIFY(!content->isVisible() && !strip->isVisible());
    window.showCanvas();
    QVERIFY(canvas->isVisible() && content->isVisible() && strip->isVisible());
    QCOMPARE(window.findChild<TopRow *>()->height(), 45);
    QCOMPARE(window.findChild<QWidget *>("inspector")->width(), 301);
    QCOMPARE(window.findChild<QWidget *>("toolRail")->width(), 49);
    window.setInspectorVisible(false);
    QVERIFY(!content->isVisible());
    window.menu("&Tools")->addAction("x");
    QCOMPARE(window.menu("&Tools")->actions().size(), 1);
    QAction mine("Mine");
    window.addToMenu(window.fileMenu(), {&mine});
    QCOMPARE(window.fileMenu()->actions().first(), &mine);
    QCOMPARE(window.fileMenu()->actions().last(), setup.actions.action("file.quit"));
}

void MainWindowShellTest::undoFollowsTheDocument()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    NoteDocument note;
    window.setDocument(&note);
    QAction *undo = setup.actions.action("edit.undo");
    QVERIFY(!undo->isEnabled());
    note.write("a");
    QVERIFY(undo->isEnabled() && undo->text().contains("Write"));
    QVERIFY(window.isWindowModified());
    undo->trigger();
    QCOMPARE(note.text(), QString());
    QVERIFY(setup.actions.action("edit.redo")->isEnabled());
    note.setReadOnly("locked");
    QVERIFY(window.windowTitle().contains("read-only"));
    window.setDocument(nullptr);
    QVERIFY(!undo->isEnabled() && !window.isWindowModified());
}

void MainWindowShellTest::closingAsksOnlyWithUnsavedWork()
{
    Setup setup;
    NoteDocument note;
    MainWindowShell window(identity, setup.services());
    window.setDocument(&note);
    window.show();
    bool wasAsked = false;
    QVERIFY(window.close());
    window.show();
    note.write("a");
    answer("Discard", wasAsked);
    QSignalSpy closing(&window, &MainWindowShell::closing);
    QVERIFY(window.close());
    QVERIFY(wasAsked);
    QCOMPARE(closing.count(), 1);
}

void MainWindowShellTest::cancelKeepsTheWindow()
{
    Setup setup;
    NoteDocument note;
    MainWindowShell window(identity, setup.services());
    window.setDocument(&note);
    window.show();
    note.write("a");
    bool wasAsked = false;
    answer("Cancel", wasAsked);
    QVERIFY(!window.close());
    QVERIFY(wasAsked && window.isVisible() && note.isModified());
}

void MainWindowShellTest::saveWritesBeforeClosing()
{
    Setup setup;
    NoteDocument note;
    MainWindowShell window(identity, setup.services());
    window.setDocument(&note);
    window.show();
    const QString path = setup.dir.filePath("a.ductus");
    note.write("a");
    note.markSaved(path, 0, {}); // has a place, but newer content
    QVERIFY(note.isModified());
    bool wasAsked = false;
    answer("Save", wasAsked);
    QVERIFY(window.close());
    QVERIFY(wasAsked && QFile::exists(path) && !note.isModified());
}

void MainWindowShellTest::droppedFilesAreTold()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    window.show();
    QSignalSpy dropped(&window, &MainWindowShell::filesDropped);
    QMimeData files;
    files.setUrls(
        {QUrl::fromLocalFile("/x/a.curves"), QUrl("https://example.org/b"), QUrl::fromLocalFile("/x/c.obj")});
    QDragEnterEvent enter({5, 5}, Qt::CopyAction | Qt::MoveAction, &files, Qt::LeftButton, {});
    enter.ignore();
    QApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({5, 5}, Qt::CopyAction | Qt::MoveAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &drop);
    QTRY_COMPARE(dropped.count(), 1);
    QCOMPARE(dropped[0][0].toStringList(), (QStringList{"/x/a.curves", "/x/c.obj"}));
    QMimeData text;
    text.setText("no file");
    QDragEnterEvent other({5, 5}, Qt::CopyAction, &text, Qt::LeftButton, {});
    other.ignore();
    QApplication::sendEvent(&window, &other);
    QVERIFY(!other.isAccepted());
}

void MainWindowShellTest::helpNamesTheTopic()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    auto *canvas = new QWidget;
    canvas->setFocusPolicy(Qt::StrongFocus);
    canvas->setProperty("helpTopic", "surface.view");
    window.setCanvas(canvas);
    window.show();
    window.showCanvas();
    window.activateWindow();
    canvas->setFocus();
    QCursor::setPos(window.mapToGlobal(QPoint(window.width() + 500, 0)));
    QTRY_VERIFY(QApplication::focusWidget() == canvas);
    QSignalSpy help(&window, &MainWindowShell::helpRequested);
    setup.actions.action("help.manual")->trigger();
    QCOMPARE(help[0][0].toString(), QString("surface.view"));
}

void MainWindowShellTest::theWindowComesBackWhereItWas()
{
    Setup setup;
    {
        MainWindowShell window(identity, setup.services());
        window.resize(700, 500);
        window.show();
        QVERIFY(window.close());
    }
    ActionCatalogue actions(&setup.settings);
    MainWindowShell window(identity, {&setup.settings, &setup.jobs, &actions});
    QCOMPARE(window.size(), QSize(700, 500));
}

void MainWindowShellTest::themeChangesAtOnce()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    QSignalSpy changed(&window, &MainWindowShell::themeChanged);
    setup.actions.action("view.themeLight")->trigger();
    QCOMPARE(coloursOf(QApplication::palette()).isDark, false);
    setup.actions.action("view.themeDark")->trigger();
    QCOMPARE(coloursOf(QApplication::palette()).isDark, true);
    QCOMPARE(changed.count(), 2);
    QVERIFY(setup.actions.action("view.themeDark")->isChecked());
}

void MainWindowShellTest::narrowRowsFoldTheirMenus()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    auto *row = window.findChild<TopRow *>();
    auto *centre = new QWidget;
    centre->setMinimumWidth(380);
    auto *layout = new QHBoxLayout(centre);
    layout->addWidget(new QLabel("centre"));
    window.setCanvas(new QWidget);
    window.setCentre(centre);
    window.showCanvas();
    window.resize(1280, 700);
    window.show();
    QVERIFY(!row->menusAreFolded());
    QVERIFY(std::abs(centre->geometry().center().x() - 640) <= 1);
    row->resize(520, row->height());
    QVERIFY(row->menusAreFolded());
    QVERIFY(centre->geometry().right() < 520);
}

void MainWindowShellTest::narrowRowsComeToRest()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    window.show();
    auto *row = window.findChild<TopRow *>();
    LayoutRequests requests;
    row->installEventFilter(&requests);
    for (int width = 200; width <= 1000; width += 20) {
        row->resize(width, row->height());
        requests.count = 0;
        for (int round = 0; round < 50; ++round)
            QCoreApplication::sendPostedEvents();
        QVERIFY2(requests.count < 10, qPrintable(QStringLiteral("%1 at %2").arg(requests.count).arg(width)));
    }
}

void MainWindowShellTest::errorsAreShownCancelsAreNot()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    window.show();
    window.showError(cancelledError("Reading"));
    QVERIFY(!window.messages()->isVisible());
    bool ran = false;
    window.showError({ErrorCode::Malformed, "Reading", "bad", "", ""}, "Again", [&] { ran = true; });
    QVERIFY(window.messages()->isVisible());
    QTest::mouseClick(window.messages()->findChild<QPushButton *>(), Qt::LeftButton);
    QVERIFY(ran && !window.messages()->isVisible());
}

void MainWindowShellTest::everythingIsReachedByKeyboard()
{
    Setup setup;
    MainWindowShell window(identity, setup.services());
    window.resize(1280, 800);
    window.show();
    window.messages()->warning("Something", "Do something.");
    KeyboardWalk walk = walkByKeyboard(window);
    QVERIFY2(walk.problems.isEmpty(), qPrintable(walk.problems.join("\n")));
    window.openSettings();
    auto *dialog = window.findChild<SettingsDialog *>();
    for (int page = 0; page < dialog->pageCount(); ++page) {
        dialog->showPage(page);
        walk = walkByKeyboard(*dialog);
        QVERIFY2(walk.problems.isEmpty(),
                 qPrintable(QString::number(page) + ": " + walk.problems.join("\n")));
    }
}

DUCTUS_WIDGET_TEST_MAIN(MainWindowShellTest)
#include "main_window_shell_test.moc"
