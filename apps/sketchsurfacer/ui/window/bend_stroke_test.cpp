// "This line should swing out a little more": one stroke chosen, a handle of it dragged; the surface follows.
// By mouse and keys on the real window.
#include "geometry/nearest.h"
#include "sketchsurfacer/ui/testing/app_under_test.h"

#include <QtTest>

using namespace ductus;
using namespace ductus::testing;

class BendStrokeTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void oneChosenStrokeHasHandles();
    void aDraggedHandleBendsTheStroke();
    void theWheelWidensTheBend();
    void escapeForgetsTheDrag();
    void withCtrlItSlidesOverTheSurface();

private:
    const std::vector<Vec3> &points() const { return mApp->window->sketch().strokes().strokes[mLine].points; }
    QPoint onScreen(const Vec3 &p) const { return mApp->window->view().camera().project(p)->toPoint(); }
    /// The inner handle seen best.
    StrokeHandle handle() const;
    void grab(const QPoint &at, Qt::KeyboardModifiers modifiers = {}) const;
    void moveTo(const QPoint &at, Qt::KeyboardModifiers modifiers = {}) const;
    void let(const QPoint &at, Qt::KeyboardModifiers modifiers = {}) const;

    std::unique_ptr<App> mApp;
    std::size_t mLine = 0;
};

StrokeHandle BendStrokeTest::handle() const
{
    const std::vector<StrokeHandle> handles = mApp->window->tools().strokeHandles();
    return handles.size() > 2 ? handles[handles.size() / 2] : StrokeHandle();
}

void BendStrokeTest::grab(const QPoint &at, Qt::KeyboardModifiers modifiers) const
{
    QTest::mouseMove(&mApp->window->view(), at);
    QTest::mousePress(&mApp->window->view(), Qt::LeftButton, modifiers, at);
}

void BendStrokeTest::moveTo(const QPoint &at, Qt::KeyboardModifiers modifiers) const
{
    SketchView &view = mApp->window->view();
    QMouseEvent move(QEvent::MouseMove, QPointF(at), view.mapToGlobal(QPointF(at)), Qt::NoButton,
                     Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(&view, &move);
}

void BendStrokeTest::let(const QPoint &at, Qt::KeyboardModifiers modifiers) const
{
    QTest::mouseRelease(&mApp->window->view(), Qt::LeftButton, modifiers, at);
}

void BendStrokeTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    SurfacerWindow &window = *mApp->window;
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(mApp->open("bottle"));
    mApp->chooseQuickOptions();
    mApp->press(Qt::Key_Return, Qt::ControlModifier);
    QVERIFY(mApp->waitForResult());
    QTRY_VERIFY(window.view().frameCount() > 0);
    mApp->press(Qt::Key_V);
}

void BendStrokeTest::oneChosenStrokeHasHandles()
{
    SurfacerWindow &window = *mApp->window;
    QVERIFY(window.tools().strokeHandles().empty());
    const QString before = window.tools().hint();
    // The long one whose middle is seen nearest to the eye: an outline of the bottle.
    const std::vector<Stroke> &strokes = window.sketch().strokes().strokes;
    double longest = 0.0;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (const double length = polylineLength(strokes[i].points);
            !isClosedLine(strokes[i].points) && length > longest &&
            window.view().strokeAt(onScreen(strokes[i].points[strokes[i].points.size() / 2])) == int(i)) {
            longest = length;
            mLine = i;
        }
    QVERIFY(longest > 0.0);
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, onScreen(points()[points().size() / 2]));
    QCOMPARE(window.presenter().selection(), std::vector{strokes[mLine].id});
    const std::vector<StrokeHandle> handles = window.tools().strokeHandles();
    QVERIFY2(handles.size() >= 3 && handles.size() <= 8, qPrintable(QString::number(handles.size())));
    QVERIFY((handles.front().point - points().front()).norm() < 1e-12);
    QVERIFY((handles.back().point - points().back()).norm() < 1e-12);
    QVERIFY(window.tools().hint() != before);
    mApp->shot("bend-1-handles");
}

void BendStrokeTest::aDraggedHandleBendsTheStroke()
{
    SurfacerWindow &window = *mApp->window;
    const StrokeSet before = window.sketch().strokes();
    const std::vector<Vec3> old = points();
    const TriangleMesh surface = mApp->surface();
    const ViewCamera camera = window.view().camera();
    const StrokeHandle grabbed = handle();
    const QPoint from = onScreen(grabbed.point), to = from + QPoint(-46, 0);
    grab(from);
    for (int x = -6; x > -46; x -= 8)
        moveTo(from + QPoint(x, 0));
    moveTo(to);
    mApp->shot("bend-2-drag");
    let(to);
    QVERIFY(window.view().camera() == camera); // bent, not turned
    double nearest = 1e9;
    for (const Vec3 &p : points()) {
        const QPointF at = *camera.project(p) - QPointF(to);
        nearest = std::min(nearest, std::hypot(at.x(), at.y()));
    }
    QVERIFY2(nearest < 4.0, qPrintable(QString::number(nearest)));
    QVERIFY(points().front() == old.front() && points().back() == old.back());
    for (std::size_t i = 0; i < before.strokes.size(); ++i)
        QCOMPARE(window.sketch().strokes().strokes[i].points == before.strokes[i].points, i != mLine);
    QCOMPARE(window.sketch().undoStack()->undoText(), QString("Bend stroke"));
    // The surface follows, worked into the one there was.
    QVERIFY(mApp->waitForResult());
    QCOMPARE(window.sketch().result()->strokeUpdates, 1);
    const auto worst = [&](const TriangleMesh &mesh) {
        const NearestOnMesh tree(mesh);
        double most = 0.0;
        for (const Vec3 &p : points())
            most = std::max(most, tree.nearest(p).distance);
        return most / before.box().diagonal();
    };
    const double was = worst(surface), is = worst(mApp->surface());
    qInfo("the bent stroke was up to %.2f %% off the surface, and is %.2f %%", 100 * was, 100 * is);
    QVERIFY(was > 0.02 && is < 0.5 * was);
    mApp->shot("bend-3-followed");
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(points() == old);
    QVERIFY(window.sketch().isUpToDate() && sameMesh(mApp->surface(), surface));
}

void BendStrokeTest::theWheelWidensTheBend()
{
    SurfacerWindow &window = *mApp->window;
    window.surfacing().setFollowsEdits(false);
    const ViewCamera camera = window.view().camera();
    const auto movedShare = [&](int notches) {
        const std::vector<Vec3> old = points();
        const QPoint from = onScreen(handle().point);
        grab(from);
        moveTo(from + QPoint(-30, 0));
        const QPointF at = from + QPoint(-30, 0);
        QWheelEvent wheel(at, window.view().mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::LeftButton, {},
                          Qt::NoScrollPhase, false);
        if (notches != 0)
            QCoreApplication::sendEvent(&window.view(), &wheel);
        let(at.toPoint());
        double stayed = 0.0;
        for (const Vec3 &p : old)
            stayed += std::find(points().begin(), points().end(), p) != points().end();
        mApp->press(Qt::Key_Z, Qt::ControlModifier);
        return 1.0 - stayed / double(old.size());
    };
    const double narrow = movedShare(0), wide = movedShare(3), back = movedShare(-3);
    QVERIFY2(wide > 1.2 * narrow, qPrintable(QString("%1 %2").arg(narrow).arg(wide)));
    QVERIFY2(std::abs(back - narrow) < 0.02, qPrintable(QString("%1 %2").arg(narrow).arg(back)));
    QVERIFY(window.view().camera() == camera); // not zoomed
}

void BendStrokeTest::escapeForgetsTheDrag()
{
    SurfacerWindow &window = *mApp->window;
    const int steps = window.sketch().undoStack()->index();
    const std::vector<Vec3> old = points();
    const QPoint from = onScreen(handle().point);
    grab(from);
    moveTo(from + QPoint(-30, 0));
    mApp->press(Qt::Key_Escape);
    let(from + QPoint(-30, 0));
    QVERIFY(points() == old);
    QCOMPARE(window.sketch().undoStack()->index(), steps);
}

void BendStrokeTest::withCtrlItSlidesOverTheSurface()
{
    SurfacerWindow &window = *mApp->window;
    if (window.tools().strokeHandles().empty()) // Esc chose nothing
        window.presenter().setSelection({window.sketch().strokes().strokes[mLine].id});
    const NearestOnMesh tree(mApp->surface());
    const StrokeHandle grabbed = handle();
    const QPoint from = onScreen(grabbed.point);
    // To the side where there is surface and no other stroke to snap to.
    QPoint to;
    for (const int x : {-26, 26, -20, 20, -34, 34})
        if (to.isNull() && window.view().surfaceAt(from + QPoint(x, 3)) &&
            window.view().strokeAt(from + QPoint(x, 3), 10.0, int(mLine)) < 0)
            to = from + QPoint(x, 3);
    QVERIFY(!to.isNull());
    const Vec3 under = window.view().surfaceAt(to)->point;
    grab(from, Qt::ControlModifier);
    moveTo(to, Qt::ControlModifier);
    let(to, Qt::ControlModifier);
    double nearest = 1e9;
    for (const Vec3 &p : points())
        nearest = std::min(nearest, (p - under).norm());
    QVERIFY(nearest < 0.01 * window.view().extent().diagonal());
    QVERIFY(tree.nearest(under).distance < 1e-9 * window.view().extent().diagonal());
    QCOMPARE(window.sketch().undoStack()->undoText(), QString("Bend stroke"));
}

QTEST_MAIN(BendStrokeTest)
#include "bend_stroke_test.moc"
