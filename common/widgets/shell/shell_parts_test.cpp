#include "document/settings/action_catalogue.h"
#include "widgets/shell/action_search.h"
#include "widgets/shell/fuzzy_match.h"
#include "widgets/shell/job_chip.h"
#include "widgets/shell/job_popup.h"
#include "widgets/shell/job_words.h"
#include "widgets/shell/message_bar.h"
#include "widgets/testing/widget_test_main.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>
#include <QToolButton>

using namespace ductus;

class ShellPartsTest : public QObject
{
    Q_OBJECT
private slots:
    void fuzzyFindsLettersInOrder();
    void fuzzyPrefersBeginsAndPieces();
    void errorsBecomeMessages();
    void messagesStandInLine();
    void messageActionsRunOnce();
    void keyedMessagesReplace();
    void successGoesByItself();
    void theChipTellsTheJob();
    void theChipCancels();
    void theListShowsAllJobs();
    void quietJobsAreNotShown();
    void timesAreSaidInWords();
    void searchFindsAndRuns();
    void searchRemembersWhatWasChosen();
    void searchSkipsWhatCannotBeDone();
};

void ShellPartsTest::fuzzyFindsLettersInOrder()
{
    QVERIFY(fuzzyMatch("nrg", "New region"));
    QVERIFY(fuzzyMatch("NEW R", "New region"));
    QVERIFY(!fuzzyMatch("rn", "New r"));
    QVERIFY(!fuzzyMatch("new regions", "New region"));
    QCOMPARE(fuzzyMatch("nr", "New region")->positions, (QList<int>{0, 4}));
    QVERIFY(fuzzyMatch("", "anything"));
    QVERIFY(!fuzzyMatch("x", ""));
    QVERIFY(fuzzyMatch("\u00fc", "\u00dcber"));
}

void ShellPartsTest::fuzzyPrefersBeginsAndPieces()
{
    const auto score = [](const char *typed, const char *name) { return fuzzyMatch(typed, name)->score; };
    QVERIFY(score("sa", "Save") > score("sa", "Use all"));
    QVERIFY(score("ex", "Export surface") > score("ex", "Hide next"));
    QVERIFY(score("save", "Save") > score("save", "Save as"));
    QVERIFY(score("sf", "Surface") < score("sf", "Show folds"));
}

void ShellPartsTest::errorsBecomeMessages()
{
    const Message message = messageFrom({ErrorCode::Malformed, "Reading the sketch", "x is not a number",
                                         "export it again", "hat.curves:12"});
    QCOMPARE(message.kind, MessageKind::Error);
    QCOMPARE(message.what, QString("Reading the sketch failed: x is not a number (hat.curves:12)."));
    QCOMPARE(message.remedy, QString("Export it again."));
    MessageBar bar;
    bar.show(cancelledError("Reading"));
    QVERIFY(bar.isHidden());
    bar.show(Error{ErrorCode::Malformed, "Reading <b>", "a < b", "", ""});
    QVERIFY(!bar.isHidden());
    QVERIFY(bar.findChildren<QLabel *>()[1]->text().contains("&lt;b&gt;"));
}

void ShellPartsTest::messagesStandInLine()
{
    MessageBar bar;
    QSignalSpy shown(&bar, &MessageBar::shown);
    bar.warning("first", "do this");
    bar.info("second");
    QCOMPARE(shown.count(), 2);
    QCOMPARE(bar.messages().size(), 2);
    QTest::keyClick(&bar, Qt::Key_Escape);
    QCOMPARE(bar.messages().last().what, QString("first"));
    QTest::mouseClick(bar.findChild<QToolButton *>(), Qt::LeftButton);
    QVERIFY(bar.isHidden());
    bar.closeCurrent();
    for (int i = 0; i < 50; ++i)
        bar.info(QString::number(i));
    QVERIFY(bar.messages().size() <= 20);
    QCOMPARE(bar.messages().last().what, QString("49"));
}

void ShellPartsTest::messageActionsRunOnce()
{
    MessageBar bar;
    int runs = 0;
    bar.show(Message{MessageKind::Info, "The file changed on the disk.", {}, "Load it", [&] { ++runs; }});
    QTest::mouseClick(bar.findChild<QPushButton *>(), Qt::LeftButton);
    QCOMPARE(runs, 1);
    QVERIFY(bar.isHidden());
}

void ShellPartsTest::keyedMessagesReplace()
{
    MessageBar bar;
    Message message{MessageKind::Warning, "one"};
    message.key = "disk";
    bar.show(message);
    bar.info("between");
    message.what = "two";
    bar.show(message);
    QCOMPARE(bar.messages().size(), 2);
    QCOMPARE(bar.messages().last().what, QString("two"));
    bar.withdraw("disk");
    QCOMPARE(bar.messages().last().what, QString("between"));
}

void ShellPartsTest::successGoesByItself()
{
    MessageBar bar;
    Message message{MessageKind::Success, "Done"};
    message.secondsShown = 1;
    bar.show(message);
    QVERIFY(!bar.isHidden());
    QTRY_VERIFY_WITH_TIMEOUT(bar.isHidden(), 4000);
}

namespace {

JobId startWaiting(JobRunner &runner, const QString &title, bool quiet = false)
{
    JobSpec spec{{}, title};
    spec.isQuiet = quiet;
    return runner.start<int>(
        spec,
        [](const JobControl &control) -> Result<int> {
            for (int i = 0; i < 1000 && !control.isCancelled(); ++i) {
                control.progress(0.25, "Fitting");
                QThread::msleep(5);
            }
            return 1;
        },
        [](Result<int>) {});
}

} // namespace

void ShellPartsTest::theChipTellsTheJob()
{
    JobRunner runner;
    JobChip chip(runner);
    QVERIFY(chip.isHidden());
    startWaiting(runner, "Surfacing");
    QVERIFY(!chip.isHidden());
    QVERIFY(chip.text().contains("Surfacing")); // until a stage is known
    QTRY_VERIFY(chip.text().contains("Fitting") && chip.text().contains("25"));
    startWaiting(runner, "Exporting");
    QTRY_VERIFY(chip.text().contains("+1"));
    runner.cancelAll();
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(chip.isHidden());
}

void ShellPartsTest::theChipCancels()
{
    JobRunner runner;
    JobChip chip(runner);
    startWaiting(runner, "Surfacing");
    QTest::mouseClick(chip.findChild<QToolButton *>(), Qt::LeftButton);
    QVERIFY(runner.jobs().first().isCancelling);
    QTRY_VERIFY(runner.jobs().isEmpty());
}

void ShellPartsTest::theListShowsAllJobs()
{
    JobRunner runner;
    JobChip chip(runner);
    startWaiting(runner, "Surfacing");
    startWaiting(runner, "Exporting");
    chip.openList();
    auto *popup = chip.findChild<JobPopup *>();
    QVERIFY(popup && popup->isVisible());
    const auto cancels = popup->findChildren<QToolButton *>();
    QCOMPARE(cancels.size(), 2);
    QCOMPARE(cancels[0]->accessibleName(), QString("Cancel Surfacing"));
    QTest::mouseClick(cancels[1], Qt::LeftButton);
    QTRY_COMPARE(runner.jobs().size(), 1);
    QCOMPARE(runner.jobs()[0].spec.title, QString("Surfacing"));
    runner.cancelAll();
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(popup->findChildren<QToolButton *>().isEmpty() ||
            !popup->findChildren<QToolButton *>()[0]->isVisible());
}

void ShellPartsTest::quietJobsAreNotShown()
{
    JobRunner runner;
    JobChip chip(runner);
    startWaiting(runner, "Autosaving", true);
    QTest::qWait(80);
    QVERIFY(chip.isHidden());
    runner.cancelAll();
    QVERIFY(runner.waitForAll(5000));
}

void ShellPartsTest::timesAreSaidInWords()
{
    QCOMPARE(remainingWords(std::nullopt), QString());
    QCOMPARE(remainingWords(2), QString("a few seconds"));
    QCOMPARE(remainingWords(12), QString("about 15 s"));
    QCOMPARE(remainingWords(58), QString("about 1 min"));
    QCOMPARE(remainingWords(150), QString("about 2 min"));
    QCOMPARE(remainingWords(5400), QString("about 1.5 h"));
    QVERIFY(percentWords(1.0).startsWith("99"));
    QVERIFY(percentWords(0.629).startsWith("62"));
}

void ShellPartsTest::searchFindsAndRuns()
{
    ActionCatalogue actions;
    QStringList ran;
    for (const char *name : {"Open", "New region", "Export surface", "Merge regions"}) {
        const QString text = QString::fromLatin1(name);
        actions.add({text, text, "Teaches.", "stroke"}, [&ran, text] { ran << text; });
    }
    QWidget window;
    window.resize(800, 600);
    window.show();
    ActionSearch search(actions, &window);
    search.openOver(window);
    QCOMPARE(search.shownIds().size(), 4);
    QTest::keyClicks(search.field(), "reg");
    QCOMPARE(search.shownIds(), (QStringList{"New region", "Merge regions"}));
    QTest::keyClick(search.field(), Qt::Key_Down);
    QTest::keyClick(search.field(), Qt::Key_Return);
    QCOMPARE(ran, QStringList{"Merge regions"});
    QVERIFY(!search.isVisible());
    search.openOver(window);
    QTest::keyClicks(search.field(), "zzz");
    QTest::keyClick(search.field(), Qt::Key_Return);
    QCOMPARE(ran.size(), 1);
}

void ShellPartsTest::searchRemembersWhatWasChosen()
{
    ActionCatalogue actions;
    for (const char *name : {"Open", "Save", "Quit"})
        actions.add({name, name, "", ""});
    QWidget window;
    ActionSearch search(actions, &window);
    search.setLast({"Open"});
    search.openOver(window);
    QCOMPARE(search.shownIds(), (QStringList{"Save", "Quit", "Open"}));
    QTest::keyClicks(search.field(), "quit");
    QTest::keyClick(search.field(), Qt::Key_Return);
    search.openOver(window);
    QCOMPARE(search.shownIds().first(), QString("Quit"));
}

void ShellPartsTest::searchSkipsWhatCannotBeDone()
{
    ActionCatalogue actions;
    int runs = 0;
    actions.add({"Save", "Save", "", ""}, [&] { ++runs; });
    actions.add({"Hidden", "Save hidden", "", ""})->setVisible(false);
    actions.setDisabledReason("Save", "Nothing is open.");
    QWidget window;
    ActionSearch search(actions, &window);
    search.openOver(window);
    QCOMPARE(search.shownIds(), QStringList{"Save"});
    QTest::keyClick(search.field(), Qt::Key_Return);
    QCOMPARE(runs, 0);
}

DUCTUS_WIDGET_TEST_MAIN(ShellPartsTest)
#include "shell_parts_test.moc"
