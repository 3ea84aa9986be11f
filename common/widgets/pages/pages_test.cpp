#include "document/settings/action_catalogue.h"
#include "widgets/pages/appearance_page.h"
#include "widgets/pages/pressure_curve_editor.h"
#include "widgets/pages/pressure_test_field.h"
#include "widgets/pages/recent_row.h"
#include "widgets/pages/recovery_notice.h"
#include "widgets/pages/sample_card.h"
#include "widgets/pages/shortcuts_page.h"
#include "widgets/pages/start_page.h"
#include "widgets/pages/tablet_page.h"
#include "widgets/testing/keyboard_walk.h"
#include "widgets/testing/widget_test_main.h"

#include <QKeySequenceEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace ductus;

namespace {

void pressNewKeys(ShortcutsPage &page, const QKeySequence &keys)
{
    auto *edit = page.findChild<QKeySequenceEdit *>();
    edit->setKeySequence(keys);
    emit edit->editingFinished();
}

QPushButton *button(QWidget &page, const QString &name)
{
    for (QPushButton *candidate : page.findChildren<QPushButton *>()) {
        if (candidate->accessibleName() == name)
            return candidate;
    }
    return nullptr;
}

} // namespace

class PagesTest : public QObject
{
    Q_OBJECT
private slots:
    void cardsAndRowsOpen();
    void missingFilesDoNotOpen();
    void thePageWalksByKeyboard();
    void unsavedWorkWaitsForADecision();
    void newKeysApplyAtOnce();
    void takenKeysAreShownFirst();
    void themeChoiceIsASetting();
    void theCurveIsRemembered();
    void theCurveMovesByKeys();
    void theFieldTakesThePen();
};

void PagesTest::cardsAndRowsOpen()
{
    StartPage page;
    page.setSamples({{"Car", "Symmetry.", "no such picture.png", "car"}, {"Hat", "Curves.", {}, "hat"}});
    page.setRecent({{"/x/a.ductus", {}, false}});
    page.resize(1000, 700);
    page.show();
    QSignalSpy sample(&page, &StartPage::openSample);
    QSignalSpy file(&page, &StartPage::openFile);
    QSignalSpy fresh(&page, &StartPage::newRequested);
    const auto cards = page.findChildren<SampleCardButton *>();
    QCOMPARE(cards.size(), 2);
    QTest::mouseClick(cards[1], Qt::LeftButton);
    QTest::keyClick(cards[0], Qt::Key_Space);
    QCOMPARE(sample.count(), 2);
    QCOMPARE(sample[0][0].toString(), QString("hat"));
    QTest::keyClick(page.findChild<RecentRow *>(), Qt::Key_Return);
    QCOMPARE(file[0][0].toString(), QString("/x/a.ductus"));
    QTest::mouseClick(button(page, "New"), Qt::LeftButton);
    QCOMPARE(fresh.count(), 1);
    QVERIFY(!page.grab().isNull());
}

void PagesTest::missingFilesDoNotOpen()
{
    StartPage page;
    page.setRecent({{"/x/gone.ductus", {}, true}});
    page.show();
    QSignalSpy file(&page, &StartPage::openFile);
    QSignalSpy forget(&page, &StartPage::forgetFile);
    auto *row = page.findChild<RecentRow *>();
    QVERIFY(row->accessibleName().contains("missing"));
    QTest::mouseClick(row, Qt::LeftButton);
    QCOMPARE(file.count(), 0);
    QTest::keyClick(row, Qt::Key_Delete);
    QCOMPARE(forget.count(), 1);
}

void PagesTest::thePageWalksByKeyboard()
{
    StartPage page;
    page.setSamples({{"Car", "Symmetry.", {}, "car"}});
    page.setRecent({{"/x/a.ductus", {}, false}});
    page.show();
    const KeyboardWalk walk = walkByKeyboard(page);
    QVERIFY2(walk.problems.isEmpty(), qPrintable(walk.problems.join("\n")));
    QVERIFY(walk.visited.size() >= 4);
    // The walk itself finds what is wrong.
    QWidget bad;
    auto *nameless = new TabletPage(*new Settings(QStringLiteral("/nonexistent/x.ini"), &bad), &bad);
    nameless->findChild<PressureCurveEditor *>()->setAccessibleName({});
    bad.show();
    QCOMPARE(walkByKeyboard(bad).problems.size(), 1);
}

void PagesTest::unsavedWorkWaitsForADecision()
{
    const RecoveredFile hat{"/state/1.ductus", "/x/hat.ductus", "hat", QDateTime::currentDateTime(), {}};
    const RecoveredFile car{"/state/2.ductus", {}, "car", QDateTime::currentDateTime(), {}};
    StartPage page;
    auto *notice = new RecoveryNotice({hat, car});
    page.setNotice(notice);
    page.resize(1000, 700);
    page.show();
    QSignalSpy open(notice, &RecoveryNotice::openRequested);
    QStringList discarded;
    connect(notice, &RecoveryNotice::discardRequested, this,
            [&](const RecoveredFile &file) { discarded << file.copy; });
    QTest::mouseClick(button(page, "Open the unsaved hat"), Qt::LeftButton);
    QCOMPARE(open.count(), 1);
    QTest::mouseClick(button(page, "Discard the unsaved hat"), Qt::LeftButton);
    QVERIFY(notice->isVisible() && button(page, "Open the unsaved car")->isVisible());
    QTest::mouseClick(button(page, "Discard the unsaved car"), Qt::LeftButton);
    QVERIFY(!notice->isVisible());
    QCOMPARE(discarded, (QStringList{"/state/1.ductus", "/state/2.ductus"}));
    QVERIFY(!RecoveryNotice({}).isVisible());
}

void PagesTest::newKeysApplyAtOnce()
{
    ActionCatalogue actions;
    actions.add({"file.open", "&Open...", "", "", {QKeySequence("Ctrl+O")}, "File"});
    ShortcutsPage page(actions);
    page.show();
    page.select("file.open");
    pressNewKeys(page, QKeySequence("F2"));
    QCOMPARE(actions.action("file.open")->shortcut(), QKeySequence("F2"));
    QTest::mouseClick(button(page, "No keys"), Qt::LeftButton);
    QVERIFY(actions.action("file.open")->shortcuts().isEmpty());
}

void PagesTest::takenKeysAreShownFirst()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    ActionCatalogue actions(&settings);
    actions.add({"file.open", "&Open...", "", "", {QKeySequence("Ctrl+O")}, "File"});
    actions.add({"edit.undo", "&Undo", "", "", {QKeySequence("Ctrl+Z")}, "Edit"});
    ShortcutsPage page(actions);
    page.show();
    page.select("file.open");
    pressNewKeys(page, QKeySequence("Ctrl+Z"));
    QVERIFY(page.conflictText().contains("Undo"));
    QCOMPARE(actions.action("file.open")->shortcut(), QKeySequence("Ctrl+O")); // nothing taken yet
    QTest::mouseClick(button(page, "Use it here instead"), Qt::LeftButton);
    QCOMPARE(actions.action("file.open")->shortcut(), QKeySequence("Ctrl+Z"));
    QVERIFY(actions.action("edit.undo")->shortcuts().isEmpty());
    QVERIFY(page.conflictText().isEmpty());
    QTest::mouseClick(button(page, "Default keys"), Qt::LeftButton);
    QCOMPARE(actions.action("file.open")->shortcut(), QKeySequence("Ctrl+O"));
}

void PagesTest::themeChoiceIsASetting()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    AppearancePage page(settings);
    page.show();
    QTest::mouseClick(page.findChildren<QAbstractButton *>()[2], Qt::LeftButton);
    QCOMPARE(themeChoice(settings), ThemeChoice::Light);
}

void PagesTest::theCurveIsRemembered()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    {
        TabletPage page(settings);
        page.show();
        auto *editor = page.findChild<PressureCurveEditor *>();
        // Takes the second point up.
        const QPoint at(editor->width() / 3, editor->height() / 3);
        QTest::mousePress(editor, Qt::LeftButton, {}, at);
        QTest::mouseRelease(editor, Qt::LeftButton, {}, at);
    }
    QVERIFY(!(PressureCurve::fromText(settings.value(pressureCurveSetting)) == PressureCurve()));
    TabletPage page(settings);
    QVERIFY(!(page.findChild<PressureCurveEditor *>()->curve() == PressureCurve()));
    QTest::mouseClick(button(page, "Straight line"), Qt::LeftButton);
    QCOMPARE(settings.value(pressureCurveSetting), QString());
}

void PagesTest::theCurveMovesByKeys()
{
    PressureCurveEditor editor;
    QSignalSpy changed(&editor, &PressureCurveEditor::curveChanged);
    QTest::keyClick(&editor, Qt::Key_Right); // the third point
    QTest::keyClick(&editor, Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(changed.count(), 1);
    QVERIFY(editor.curve().points()[2].y() > 2.0 / 3.0);
}

void PagesTest::theFieldTakesThePen()
{
    PressureTestField field;
    field.resize(240, 240);
    field.show();
    QSignalSpy pressure(&field, &PressureTestField::pressureChanged);
    QTest::mousePress(&field, Qt::LeftButton, {}, {50, 50});
    QTest::mouseMove(&field, {80, 80});
    QTest::mouseRelease(&field, Qt::LeftButton, {}, {80, 80});
    QVERIFY(!field.isEmpty());
    QCOMPARE(pressure.last()[0].toDouble(), -1.0);
    field.clear();
    QVERIFY(field.isEmpty());
}

DUCTUS_WIDGET_TEST_MAIN(PagesTest)
#include "pages_test.moc"
