// "A sharp edge is missing where I forgot a stroke: I draw it on the surface, and the crease appears along
// it" (thesis Fig. III.17), by mouse and keys on the real window.
#include "support/evaluation.h"
#include "support/house_sketch.h"

#include "widgets/shell/message_bar.h"

#include <QtTest>

using namespace ductus;
using namespace ductus::testing;

namespace {

// Share of the length of \a stroke along which \a mesh has a crease.
double creaseAlong(const TriangleMesh &mesh, const std::vector<Vec3> &stroke)
{
    GroundTruth truth;
    truth.mesh = house().mesh; // the measure of its tolerances
    truth.drawnCreases = {stroke};
    const Result<CreaseScore> score = creaseScore(mesh, truth);
    if (!score)
        qFatal("%s", score.error().message().c_str());
    return score->recall;
}

} // namespace

class DrawMissingStrokeTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void theDrawnStrokeBecomesACrease();
    void undoAndRedoAreExact();
    void aDeletedStrokeTakesItsCreaseAlong();
    void surfacingAnewIsAnEditOfItsOwn();

private:
    std::vector<Vec3> ridge() const { return mApp->window->sketch().strokes().strokes.back().points; }

    std::unique_ptr<App> mApp;
    TriangleMesh mWithout, mWith;
};

void DrawMissingStrokeTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    SurfacerWindow &window = *mApp->window;
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(surfaceHouseWithoutRidge(*mApp, 3000, 2));
    QCOMPARE(window.view().mode(), ViewMode::Surface);
    mWithout = mApp->surface();
    mApp->shot("story-1-without");
}

void DrawMissingStrokeTest::theDrawnStrokeBecomesACrease()
{
    SurfacerWindow &window = *mApp->window;
    window.view().setPreset(ViewPreset::Top);
    mApp->press(Qt::Key_D);
    QCOMPARE(window.tools().tool(), ToolKind::DrawStroke);
    std::vector<QPoint> line;
    for (int i = 0; i <= 40; ++i)
        line.push_back(window.view().camera().project(Vec3(0.0, 0.39, 0.24 - 0.48 * i / 40.0))->toPoint());
    bool sawPreview = false;
    const auto watch = connect(&window.presenter(), &SketchPresenter::resultShown, this, [&] {
        sawPreview = sawPreview || window.presenter().resultView()->isPreview;
    });
    QElapsedTimer clock;
    clock.start();
    const std::size_t strokes = window.sketch().strokes().strokes.size();
    mApp->drag(line);
    QCOMPARE(window.sketch().strokes().strokes.size(), strokes + 1);
    const double before = creaseAlong(mWithout, ridge());
    QVERIFY2(before < 0.05, qPrintable(QString::number(before)));
    QVERIFY(mApp->waitForResult());
    disconnect(watch);
    const double along = creaseAlong(mApp->surface(), ridge());
    qInfo("from the stroke to its crease: %lld ms; the crease follows %.0f %% of it", clock.elapsed(),
          100 * along);
    mWith = mApp->surface();
    window.view().setPreset(ViewPreset::ThreeQuarter);
    mApp->shot("story-2-with");
    mApp->press(Qt::Key_3);
    mApp->shot("story-3-regions");
    mApp->press(Qt::Key_4);
    QVERIFY2(along > 0.8, qPrintable(QString::number(along)));
    QVERIFY2(sawPreview, "the labels are shown before the final mesh");
    // Worked into what there was, not surfaced from the beginning.
    QCOMPARE(window.sketch().result()->strokeUpdates, 1);
    QVERIFY(window.messages()->messages().isEmpty());
}

void DrawMissingStrokeTest::undoAndRedoAreExact()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.sketch().isUpToDate()); // at once, nothing is solved
    QVERIFY(sameMesh(mApp->surface(), mWithout));
    mApp->press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(window.sketch().isUpToDate());
    QVERIFY(sameMesh(mApp->surface(), mWith));
}

void DrawMissingStrokeTest::aDeletedStrokeTakesItsCreaseAlong()
{
    SurfacerWindow &window = *mApp->window;
    const std::vector<Vec3> drawn = ridge();
    mApp->press(Qt::Key_V);
    window.view().setPreset(ViewPreset::Top);
    QVERIFY(mApp->waitForResult()); // drawn again, so that the pointer meets what is seen
    const QPoint middle = window.view().camera().project(drawn[drawn.size() / 2])->toPoint();
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, middle);
    QCOMPARE(window.presenter().selection(), std::vector{window.sketch().strokes().strokes.back().id});
    mApp->press(Qt::Key_Delete);
    QVERIFY(mApp->waitForResult());
    QCOMPARE(window.sketch().result()->strokeUpdates, 2);
    QVERIFY2(creaseAlong(mApp->surface(), drawn) < 0.5,
             qPrintable(QString::number(creaseAlong(mApp->surface(), drawn))));
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(sameMesh(mApp->surface(), mWith));
}

void DrawMissingStrokeTest::surfacingAnewIsAnEditOfItsOwn()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!window.sketch().isUpToDate());
    QVERIFY(mApp->waitForResult());
    QCOMPARE(window.sketch().result()->strokeUpdates, 0);
    QVERIFY(creaseAlong(mApp->surface(), ridge()) > 0.8);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.sketch().isUpToDate());
    QVERIFY(sameMesh(mApp->surface(), mWith));
}

QTEST_MAIN(DrawMissingStrokeTest)
#include "draw_missing_stroke_test.moc"
