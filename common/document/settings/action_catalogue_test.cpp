#include "document/settings/action_catalogue.h"

#include <QGuiApplication>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

namespace {

ActionSpec openSpec()
{
    return {"file.open", "&Open...", "Opens a project.", "document-open", {QKeySequence("Ctrl+O")}, "File"};
}

} // namespace

class ActionCatalogueTest : public QObject
{
    Q_OBJECT
private slots:
    void actionsRunAndTeach();
    void ownShortcutsAreRemembered();
    void defaultsAreNotStored();
    void conflictsAreFoundByMode();
    void disabledOnesSayWhy();
    void plainTexts();
};

void ActionCatalogueTest::actionsRunAndTeach()
{
    ActionCatalogue catalogue;
    int runs = 0;
    QAction *open = catalogue.add(openSpec(), [&] { ++runs; });
    open->trigger();
    QCOMPARE(runs, 1);
    QVERIFY(open->toolTip().contains("Open") && !open->toolTip().contains("&Open"));
    QVERIFY(open->toolTip().contains("Opens a project."));
    QVERIFY(open->toolTip().contains(QKeySequence("Ctrl+O").toString(QKeySequence::NativeText)));
    QCOMPARE(catalogue.action("file.open"), open);
    QCOMPARE(catalogue.spec(open)->id, QString("file.open"));
    QVERIFY(!catalogue.action("none") && !catalogue.spec("none"));
    bool state = false;
    catalogue.addToggle({"view.grid", "&Grid", "Shows a grid.", ""}, [&](bool on) { state = on; })
        ->setChecked(true);
    QVERIFY(state);
}

void ActionCatalogueTest::ownShortcutsAreRemembered()
{
    QTemporaryDir dir;
    {
        Settings settings(dir.filePath("s.ini"));
        ActionCatalogue catalogue(&settings);
        catalogue.add(openSpec());
        catalogue.setShortcuts("file.open", {QKeySequence("F2"), QKeySequence("Ctrl+,")});
        QVERIFY(catalogue.hasOwnShortcuts("file.open"));
    }
    Settings settings(dir.filePath("s.ini"));
    ActionCatalogue catalogue(&settings);
    QAction *open = catalogue.add(openSpec());
    QCOMPARE(open->shortcuts(), (QList<QKeySequence>{QKeySequence("F2"), QKeySequence("Ctrl+,")}));
    catalogue.setShortcuts("file.open", {}); // none is a choice, too
    QVERIFY(ActionCatalogue(&settings).add(openSpec())->shortcuts().isEmpty());
    catalogue.resetAllShortcuts();
    QCOMPARE(open->shortcut(), QKeySequence("Ctrl+O"));
    QVERIFY(!catalogue.hasOwnShortcuts("file.open"));
}

void ActionCatalogueTest::defaultsAreNotStored()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    ActionCatalogue catalogue(&settings);
    catalogue.add(openSpec());
    catalogue.setShortcuts("file.open", {QKeySequence("Ctrl+O")});
    QVERIFY(settings.keysIn("shortcuts").isEmpty()); // a later version may change the default
}

void ActionCatalogueTest::conflictsAreFoundByMode()
{
    ActionCatalogue catalogue;
    catalogue.add(openSpec());
    ActionSpec paint{"paint.size", "Size", "", "", {QKeySequence("S")}};
    paint.mode = "paint";
    ActionSpec select{"select.same", "Same", "", "", {QKeySequence("S")}};
    select.mode = "select";
    catalogue.add(paint);
    catalogue.add(select);
    catalogue.add({"any", "Any", "", "", {QKeySequence("Ctrl+K, Ctrl+C")}});
    QCOMPARE(catalogue.conflicts("paint.size", QKeySequence("S")), QStringList());
    QCOMPARE(catalogue.conflicts("any", QKeySequence("S")), (QStringList{"paint.size", "select.same"}));
    QCOMPARE(catalogue.conflicts("any", QKeySequence("Ctrl+O")), QStringList{"file.open"});
    // Ctrl+K alone would never let Ctrl+K, Ctrl+C through.
    QCOMPARE(catalogue.conflicts("file.open", QKeySequence("Ctrl+K")), QStringList{"any"});
    QCOMPARE(catalogue.conflicts("file.open", QKeySequence()), QStringList());
}

void ActionCatalogueTest::disabledOnesSayWhy()
{
    ActionCatalogue catalogue;
    QAction *open = catalogue.add(openSpec());
    catalogue.setDisabledReason("file.open", "A job is running.");
    QVERIFY(!open->isEnabled() && open->toolTip().contains("A job is running."));
    catalogue.setDisabledReason("file.open", {});
    QVERIFY(open->isEnabled() && !open->toolTip().contains("running"));
}

void ActionCatalogueTest::plainTexts()
{
    QCOMPARE(plainText("&Open..."), QString("Open"));
    QCOMPARE(plainText("Save && quit"), QString("Save & quit"));
    QCOMPARE(plainText("Find\u2026"), QString("Find"));
    QCOMPARE(plainText("&"), QString("&"));
    QCOMPARE(plainText("開く(&O)..."), QString("開く"));
    QCOMPARE(plainText("Open (&)"), QString("Open ()"));
}

int main(int argc, char *argv[])
{
    // QAction needs the application; no test here needs a display.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QGuiApplication application(argc, argv);
    ActionCatalogueTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "action_catalogue_test.moc"
