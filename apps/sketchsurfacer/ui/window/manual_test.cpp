// F1 opens the manual at the tool in hand, and every tool has its section.
#include "sketchsurfacer/ui/window/surfacer_window.h"

#include "widgets/pages/help_window.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class ManualTest : public QObject
{
    Q_OBJECT
private slots:
    void everyToolHasItsSection();
};

void ManualTest::everyToolHasItsSection()
{
    QStandardPaths::setTestModeEnabled(true);
    QTemporaryDir folder;
    qputenv("XDG_STATE_HOME", folder.filePath("state").toUtf8());
    Settings settings(folder.filePath("settings.ini"));
    JobRunner jobs;
    ActionCatalogue actions(&settings);
    SurfacerWindow window({&settings, &jobs, &actions});
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    int tools = 0;
    for (const QString &id : actions.ids()) {
        if (!id.startsWith("tool."))
            continue;
        ++tools;
        actions.action(id)->trigger();
        emit window.helpRequested("canvas");
        auto *help = window.findChild<HelpWindow *>();
        QVERIFY(help && QTest::qWaitForWindowExposed(help));
        QCOMPARE(help->shownSection(), plainText(actions.spec(id)->text));
        if (id == "tool.seam" && qEnvironmentVariableIsSet("DUCTUS_SHOTS"))
            help->grab().save(qEnvironmentVariable("DUCTUS_SHOTS") + "/manual.png");
        emit window.helpRequested(QString());
        QCOMPARE(help->shownSection(), QString("SketchSurfacer"));
        emit window.helpRequested(id); // the pointer is over its button
        QCOMPARE(help->shownSection(), plainText(actions.spec(id)->text));
    }
    QVERIFY(tools >= 10);
}

QTEST_MAIN(ManualTest)
#include "manual_test.moc"
