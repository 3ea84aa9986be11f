// F1 opens the manual at the tool in hand, and every tool has its section.
#include "layerpainter/ui/testing/painter_under_test.h"
#include "widgets/pages/help_window.h"

using namespace ductus;

class PainterManualTest : public QObject
{
    Q_OBJECT
private slots:
    void everyToolHasItsSection();
};

void PainterManualTest::everyToolHasItsSection()
{
    PainterUnderTest app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    int tools = 0;
    for (const QString &id : app.actions.ids()) {
        if (!id.startsWith("tool."))
            continue;
        ++tools;
        app.actions.action(id)->trigger();
        emit app.window->helpRequested("canvas");
        auto *help = app.window->findChild<HelpWindow *>();
        QVERIFY(help && QTest::qWaitForWindowExposed(help));
        QCOMPARE(help->shownSection(), plainText(app.actions.spec(id)->text));
    }
    QCOMPARE(tools, 7);
    emit app.window->helpRequested(QString());
    QCOMPARE(app.window->findChild<HelpWindow *>()->shownSection(), QString("LayerPainter"));
}

QTEST_MAIN(PainterManualTest)
#include "painter_manual_test.moc"
