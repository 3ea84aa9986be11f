// "Where does my sketch say too little, and what else could it mean?": the map, and taking another reading,
// by mouse and keys.
#include "sketchsurfacer/ui/presentation/ambiguity_presenter.h"
#include "support/house_sketch.h"

#include <QToolButton>
#include <QtTest>

using namespace ductus;
using namespace ductus::testing;

class AmbiguityWindowTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void theMissingRidgeIsColoured();
    void aClickThereOffersOtherReadings();
    void undoGoesBack();

private:
    bool waitForMap()
    {
        return QTest::qWaitFor([&] { return mApp->window->ambiguity().shown() != nullptr; },
                               solveMilliseconds);
    }
    double valueNear(const Vec3 &p) const // mean over the vertices within 2 cm
    {
        const AmbiguityView &map = *mApp->window->ambiguity().shown();
        double sum = 0.0;
        int count = 0;
        for (std::size_t v = 0; v < map.values.size(); ++v)
            if ((map.mesh.mesh->vertices[v] - p).norm() < 0.03) {
                sum += map.values[v];
                ++count;
            }
        return count ? sum / count : -1.0;
    }

    std::unique_ptr<App> mApp;
    TriangleMesh mFirst, mOther;
};

void AmbiguityWindowTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    QVERIFY(!mApp->window->ambiguity().canLook());
    QVERIFY(surfaceHouseWithoutRidge(*mApp, 6000, 4));
    mFirst = mApp->surface();
}

void AmbiguityWindowTest::theMissingRidgeIsColoured()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_A);
    QCOMPARE(window.view().mode(), ViewMode::Regions);
    QVERIFY(window.ambiguity().isRunning());
    QElapsedTimer clock;
    clock.start();
    QVERIFY(waitForMap());
    qInfo("the map took %lld ms", clock.elapsed());
    QVERIFY(window.view().isAmbiguityShown() && window.view().hasMesh(SceneItem::Ambiguity));
    const double ridge = valueNear({0.0, 0.37, 0.1}), wall = valueNear({0.18, 0.08, 0.0});
    QVERIFY2(ridge > 0.15 && ridge > 3.0 * wall, qPrintable(QString("%1 %2").arg(ridge).arg(wall)));
    QVERIFY(!window.ambiguity().shown()->readings.empty());
    mApp->shot("ambiguity-1-map");
}

void AmbiguityWindowTest::aClickThereOffersOtherReadings()
{
    SurfacerWindow &window = *mApp->window;
    // The most open place that is seen.
    QPoint open;
    double most = 0.0;
    for (int y = 60; y < window.view().height() - 60; y += 6)
        for (int x = 60; x < window.view().width() - 60; x += 6)
            if (const auto hit = window.view().surfaceAt(QPointF(x, y)))
                if (const auto value = window.ambiguity().valueAt(*hit);
                    value && *value > most && window.view().strokeAt(QPointF(x, y)) < 0) {
                    most = *value;
                    open = {x, y};
                }
    QVERIFY2(most > 0.2, qPrintable(QString::number(most)));
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, open);
    QPointer<QWidget> popover = window.findChild<QWidget *>("readingPopover");
    QVERIFY(popover && popover->isVisible());
    auto *choice = popover->findChild<QToolButton *>("reading0");
    QVERIFY(choice && !choice->icon().isNull() && !choice->accessibleName().isEmpty());
    if (!qEnvironmentVariable("DUCTUS_SHOTS").isEmpty()) {
        QTest::qWait(100);
        popover->grab().save(qEnvironmentVariable("DUCTUS_SHOTS") + "/ambiguity-2-popover.png");
    }
    QTest::mouseClick(choice, Qt::LeftButton);
    QTRY_VERIFY(!popover);
    QVERIFY(!window.sketch().isUpToDate());
    QVERIFY(window.sketch().content().reading);
    QVERIFY(mApp->waitForResult());
    mOther = mApp->surface();
    QVERIFY(!sameMesh(mFirst, mOther));
    QVERIFY(waitForMap()); // of the new surface
    mApp->shot("ambiguity-3-other");
}

void AmbiguityWindowTest::undoGoesBack()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.sketch().isUpToDate());
    QVERIFY(sameMesh(mApp->surface(), mFirst));
    QTRY_VERIFY(window.ambiguity().shown()); // known from before
    mApp->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(sameMesh(mApp->surface(), mOther));
    // A scribble goes on from the reading that was chosen.
    const auto chosen = window.sketch().result()->labels;
    const Vec3 wall(0.18, 0.1, 0.0);
    window.sketch().addScribble({ScribbleKind::Lock, {wall}, 0});
    QVERIFY(mApp->waitForResult());
    QVERIFY(window.sketch().result()->labels->before == chosen);
    mApp->press(Qt::Key_A);
    QVERIFY(!window.view().isAmbiguityShown());
}

QTEST_MAIN(AmbiguityWindowTest)
#include "ambiguity_test.moc"
