// "I never said where my leaf ends, and it found out": the borders nobody marked are named, pointed out, and
// marked with one click.
#include "sketchsurfacer/ui/testing/app_under_test.h"

#include "widgets/theme/theme.h"

#include <QLabel>
#include <QPushButton>

using namespace ductus;
using namespace ductus::testing;

class FoundBorderTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void bordersNobodyMarkedAreFound();
    void pointingAtTheLineShowsThem();
    void oneClickMarksThem();

private:
    int marked() const
    {
        const auto &strokes = mApp->window->sketch().strokes().strokes;
        return int(std::count_if(strokes.begin(), strokes.end(),
                                 [](const Stroke &s) { return s.role == StrokeRole::Boundary; }));
    }

    std::unique_ptr<App> mApp;
};

void FoundBorderTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
}

void FoundBorderTest::bordersNobodyMarkedAreFound()
{
    SurfacerWindow &window = *mApp->window;
    QVERIFY(mApp->open("bent-leaf"));
    auto *row = window.findChild<QWidget *>("foundBorders");
    QVERIFY(row && !row->isVisible());
    std::vector<StrokeId> all;
    std::vector<StrokeId> known;
    for (const Stroke &stroke : window.sketch().strokes().strokes) {
        all.push_back(stroke.id);
        if (stroke.role == StrokeRole::Boundary)
            known.push_back(stroke.id);
    }
    QVERIFY(!known.empty());
    window.sketch().setRole(all, StrokeRole::Surface);
    mApp->press(Qt::Key_Return, Qt::ControlModifier);
    QVERIFY(mApp->waitForResult());
    QCOMPARE(window.presenter().foundBorders(), known);
    QVERIFY(row->isVisible());
    QVERIFY(row->findChild<QLabel *>()->text().contains(QString::number(known.size())));
    mApp->press(Qt::Key_1);
    mApp->shot("border-1-found");
}

void FoundBorderTest::pointingAtTheLineShowsThem()
{
    SurfacerWindow &window = *mApp->window;
    const StrokeId border = window.presenter().foundBorders().front();
    const auto look = [&] {
        const std::vector<Stroke> &strokes = window.sketch().strokes().strokes;
        for (std::size_t i = 0; i < strokes.size(); ++i)
            if (strokes[i].id == border)
                return window.view().strokes()[i];
        return ViewLine();
    };
    QCOMPARE(look().colours.front(), foundBorderColour(true));
    auto *row = window.findChild<QWidget *>("foundBorders");
    QEnterEvent enter(QPointF(4, 4), QPointF(4, 4), row->mapToGlobal(QPointF(4, 4)));
    QApplication::sendEvent(row, &enter);
    QCOMPARE(look().colours.front(), roleColour(StrokeRole::Boundary, true));
    QVERIFY(look().width > 1.5);
    mApp->shot("border-2-pointed-out");
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(row, &leave);
    QCOMPARE(look().colours.front(), foundBorderColour(true));
    setThemeChoice(mApp->settings, ThemeChoice::Light);
    mApp->shot("border-3-light");
}

void FoundBorderTest::oneClickMarksThem()
{
    SurfacerWindow &window = *mApp->window;
    const std::vector<StrokeId> found = window.presenter().foundBorders();
    auto *row = window.findChild<QWidget *>("foundBorders");
    const int steps = window.sketch().undoStack()->count();
    window.findChild<QPushButton *>("confirmBorders")->click();
    QCOMPARE(marked(), int(found.size()));
    QCOMPARE(window.sketch().undoStack()->count(), steps + 1);
    QVERIFY(window.presenter().foundBorders().empty());
    QVERIFY(!row->isVisible());
    QVERIFY(mApp->waitForResult());
    QVERIFY(!row->isVisible());
    mApp->shot("border-4-marked");
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(marked(), 0);
    QVERIFY(window.sketch().isUpToDate());
    QTRY_COMPARE(window.presenter().foundBorders(), found);
    QVERIFY(row->isVisible());
}

QTEST_MAIN(FoundBorderTest)
#include "found_border_test.moc"
