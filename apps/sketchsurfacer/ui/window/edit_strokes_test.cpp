// Strokes taken by a lasso, moved by hand, drawn on both sides at once; the view on a turntable: by mouse and
// keys.
#include "sketchsurfacer/ui/testing/app_under_test.h"

#include <QtTest>

using namespace ductus;
using namespace ductus::testing;

class EditStrokesTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void aLassoTakesWhatIsInside();
    void chosenStrokesAreMovedByHand();
    void aStrokeComesWithItsMirrorImage();
    void theTurntableGoesRound();

private:
    const std::vector<Stroke> &strokes() const { return mApp->window->sketch().strokes().strokes; }

    std::unique_ptr<App> mApp;
};

void EditStrokesTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    QVERIFY(mApp->open("bottle"));
    QTRY_VERIFY(mApp->window->view().frameCount() > 0);
    mApp->press(Qt::Key_V);
}

void EditStrokesTest::aLassoTakesWhatIsInside()
{
    SurfacerWindow &window = *mApp->window;
    SketchView &view = window.view();
    // Around the upper half.
    const int w = view.width(), h = view.height();
    const QPoint corners[] = {{10, 10}, {w - 10, 10}, {w - 10, h / 2}, {10, h / 2}, {10, 12}};
    const ViewCamera before = view.camera();
    QTest::mousePress(&view, Qt::LeftButton, Qt::ShiftModifier, corners[0]);
    for (std::size_t i = 1; i < std::size(corners); ++i)
        for (int step = 1; step <= 10; ++step) {
            const QPointF p = corners[i - 1] + (corners[i] - corners[i - 1]) * (step / 10.0);
            QMouseEvent move(QEvent::MouseMove, p, view.mapToGlobal(p), Qt::NoButton, Qt::LeftButton,
                             Qt::ShiftModifier);
            QCoreApplication::sendEvent(&view, &move);
        }
    mApp->shot("edit-1-lasso");
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::ShiftModifier, corners[4]);
    QVERIFY(view.camera() == before);
    const std::vector<StrokeId> chosen = window.presenter().selection();
    QVERIFY(!chosen.empty() && chosen.size() < strokes().size());
    for (const Stroke &stroke : strokes()) {
        int above = 0;
        for (const Vec3 &p : stroke.points)
            above += view.camera().project(p)->y() < h / 2;
        const bool isIn = std::find(chosen.begin(), chosen.end(), stroke.id) != chosen.end();
        QCOMPARE(isIn, 2 * above > int(stroke.points.size()));
    }
    mApp->shot("edit-2-chosen");
    const std::size_t count = strokes().size();
    mApp->press(Qt::Key_Delete);
    QCOMPARE(strokes().size(), count - chosen.size());
    QCOMPARE(window.sketch().undoStack()->count(), 1);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(strokes().size(), count);
}

void EditStrokesTest::chosenStrokesAreMovedByHand()
{
    SurfacerWindow &window = *mApp->window;
    SketchView &view = window.view();
    const Stroke before = strokes().front();
    const StrokeSet all = window.sketch().strokes();
    window.presenter().setSelection({before.id});
    const QPoint from = view.camera().project(before.points[before.points.size() / 2])->toPoint();
    QVERIFY(view.strokeAt(from) >= 0);
    window.presenter().setSelection({window.presenter().strokeId(view.strokeAt(from))});
    const StrokeId id = window.presenter().selection().front();
    const auto points = [&](const StrokeSet &set) {
        for (const Stroke &stroke : set.strokes)
            if (stroke.id == id)
                return stroke.points;
        return std::vector<Vec3>();
    };
    const ViewCamera camera = view.camera();
    mApp->drag({from, from + QPoint(20, 0), from + QPoint(40, 10), from + QPoint(60, 20)});
    QVERIFY(view.camera() == camera); // moved, not turned
    const std::vector<Vec3> old = points(all), now = points(window.sketch().strokes());
    QCOMPARE(now.size(), old.size());
    const QPointF way = *camera.project(now[now.size() / 2]) - *camera.project(old[old.size() / 2]);
    QVERIFY2(std::hypot(way.x() - 60, way.y() - 20) < 6.0,
             qPrintable(QString("%1 %2").arg(way.x()).arg(way.y())));
    for (std::size_t i = 0; i < now.size(); ++i)
        QVERIFY(((now[i] - old[i]) - (now[0] - old[0])).norm() < 1e-12);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(points(window.sketch().strokes()) == old);
    mApp->press(Qt::Key_Escape);
}

void EditStrokesTest::aStrokeComesWithItsMirrorImage()
{
    SurfacerWindow &window = *mApp->window;
    SurfaceOptions options = window.sketch().content().options;
    options.symmetry = SymmetryMode::Given;
    options.symmetryPlane = {Vec3::UnitX(), 0.0};
    window.sketch().setOptions("Change symmetry", options);
    const std::size_t before = strokes().size();
    const auto draw = [&] {
        mApp->press(Qt::Key_D);
        mApp->drag({{300, 300}, {320, 310}, {340, 330}, {360, 360}});
    };
    draw();
    QCOMPARE(strokes().size(), before + 2);
    const std::vector<Vec3> &line = strokes()[before].points, &image = strokes()[before + 1].points;
    QCOMPARE(line.size(), image.size());
    for (std::size_t i = 0; i < line.size(); ++i)
        QVERIFY((Vec3(-line[i].x(), line[i].y(), line[i].z()) - image[i]).norm() < 1e-12);
    mApp->press(Qt::Key_Z, Qt::ControlModifier); // both at once
    QCOMPARE(strokes().size(), before);
    mApp->press(Qt::Key_X, Qt::ShiftModifier);
    draw();
    QCOMPARE(strokes().size(), before + 1);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    mApp->press(Qt::Key_X, Qt::ShiftModifier);
}

void EditStrokesTest::theTurntableGoesRound()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_V);
    const Vec3 before = window.view().camera().forward();
    mApp->press(Qt::Key_G);
    QTest::qWait(400);
    mApp->press(Qt::Key_G);
    const Vec3 turned = window.view().camera().forward();
    QVERIFY((turned - before).norm() > 0.05);
    QVERIFY(std::abs(turned.y() - before.y()) < 1e-9); // the horizon stays
    QTest::qWait(100);
    QVERIFY(window.view().camera().forward() == turned);
    window.saveTurntable(mApp->dir.path(), 4);
    QTRY_VERIFY(QFile::exists(mApp->dir.filePath("turntable-003.png")));
    QTest::qWait(50);
    QVERIFY((window.view().camera().forward() - turned).norm() < 1e-9); // stands as before
    const QImage first(mApp->dir.filePath("turntable-000.png")),
        third(mApp->dir.filePath("turntable-002.png"));
    QVERIFY(first.width() >= window.view().width() && first != third);
    window.savePicture(mApp->dir.filePath("one.png"));
    QTRY_VERIFY(QFile::exists(mApp->dir.filePath("one.png")));
}

QTEST_MAIN(EditStrokesTest)
#include "edit_strokes_test.moc"
