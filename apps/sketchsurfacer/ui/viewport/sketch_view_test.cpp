// The viewport with real pixels and real mouse events.
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <QtTest>

using namespace ductus;

namespace {

TriangleMesh tetrahedron()
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

ViewMesh viewMeshOf(const TriangleMesh &mesh, Rgba colour)
{
    ShadingOptions options;
    options.colour = colour;
    ViewMesh view;
    view.mesh = std::make_shared<const TriangleMesh>(mesh);
    view.tree = std::make_shared<const RayTree>(mesh);
    view.shaded = shadedMesh(mesh, options);
    return view;
}

// Takes every drag and notes it.
class NotingTool : public ViewTool
{
public:
    bool press(const ViewPointer &, SketchView &) override { return takes; }
    void drag(const ViewPointer &, SketchView &) override { ++drags; }
    void release(const ViewPointer &, SketchView &) override { ++releases; }
    void click(const ViewPointer &, SketchView &) override { ++clicks; }
    bool takes = true;
    int drags = 0, releases = 0, clicks = 0;
};

} // namespace

class SketchViewTest : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void drawsTheMeshWhereItIsPicked();
    void hidesStrokesBehind();
    void leftDragOrbitsOrServesTheTool();
    void wheelComesNearer();
    void comparesAlongTheDivider();

private:
    QColor pixel(const QPointF &at)
    {
        return QColor(mView->grabFramebuffer().pixel((at * mView->devicePixelRatioF()).toPoint()));
    }
    QPoint centre() const { return mView->camera().project({0.25, 0.25, 0.25})->toPoint(); }

    std::unique_ptr<SketchView> mView;
};

void SketchViewTest::init()
{
    mView = std::make_unique<SketchView>();
    mView->resize(640, 480);
    mView->show();
    QVERIFY(QTest::qWaitForWindowExposed(mView.get()));
    const TriangleMesh mesh = tetrahedron();
    mView->setExtent(boundingBox(mesh.vertices), UpAxis::Y, 1.0);
    mView->setMesh(SceneItem::Surface, viewMeshOf(mesh, {220, 30, 30, 255}));
    mView->setMode(ViewMode::Surface);
    mView->frameAll();
    QTRY_VERIFY(mView->frameCount() > 0);
}

void SketchViewTest::cleanup()
{
    mView.reset();
}

void SketchViewTest::drawsTheMeshWhereItIsPicked()
{
    const auto hit = mView->surfaceAt(centre());
    QVERIFY(hit);
    QCOMPARE(hit->triangle, 3);
    const QColor inside = pixel(centre());
    QVERIFY2(inside.red() > 2 * inside.green(), qPrintable(inside.name()));
    QVERIFY(!mView->surfaceAt(QPointF(5, 5)));
    const QColor outside = pixel({5, 5});
    QVERIFY(outside.red() <= outside.blue());
    mView->setMode(ViewMode::Sketch);
    QVERIFY(!mView->surfaceAt(centre())); // what is not shown is not picked
}

void SketchViewTest::hidesStrokesBehind()
{
    const Vec3 front(0.36, 0.36, 0.36), behind(-0.6, -0.6, -0.6);
    const Vec3 across = 0.2 * mView->camera().right();
    mView->setExtent(
        [] {
            Box3 box;
            box.add({-1, -1, -1});
            box.add({1, 1, 1});
            return box;
        }(),
        UpAxis::Y, 1.0);
    mView->frameAll();
    const auto line = [&](const Vec3 &at) {
        return ViewLine{{at - across, at + across}, {{20, 220, 30, 255}}, {}, 6.0};
    };
    mView->setStrokes({line(front), line(behind)});
    const QColor seen = pixel(*mView->camera().project(front));
    QVERIFY2(seen.green() > seen.red(), qPrintable(seen.name()));
    QCOMPARE(mView->strokeAt(*mView->camera().project(front)), 0);
    mView->setStrokes({line(Vec3(0.05, 0.05, 0.05))}); // inside
    const QPointF at = *mView->camera().project({0.05, 0.05, 0.05});
    const QColor hidden = pixel(at);
    QVERIFY2(hidden.red() > hidden.green(), qPrintable(hidden.name()));
    QCOMPARE(mView->strokeAt(at), -1);
    mView->setMode(ViewMode::Sketch);
    QCOMPARE(mView->strokeAt(at), 0);
}

void SketchViewTest::leftDragOrbitsOrServesTheTool()
{
    NotingTool tool;
    mView->setTool(&tool);
    const ViewCamera before = mView->camera();
    const QPoint c = centre();
    QTest::mousePress(mView.get(), Qt::LeftButton, {}, c);
    for (int i = 1; i <= 10; ++i)
        QTest::mouseMove(mView.get(), c + QPoint(5 * i, 0));
    QTest::mouseRelease(mView.get(), Qt::LeftButton, {}, c + QPoint(50, 0));
    QVERIFY(tool.drags >= 10);
    QCOMPARE(tool.releases, 1);
    QVERIFY(mView->camera() == before);

    tool.takes = false;
    QTest::mouseClick(mView.get(), Qt::LeftButton, {}, c);
    QCOMPARE(tool.clicks, 1);
    QTest::mousePress(mView.get(), Qt::LeftButton, {}, c);
    for (int i = 1; i <= 10; ++i)
        QTest::mouseMove(mView.get(), c + QPoint(5 * i, 0));
    QTest::mouseRelease(mView.get(), Qt::LeftButton, {}, c + QPoint(50, 0));
    QCOMPARE(tool.clicks, 1); // a drag is no click
    QVERIFY((mView->camera().forward() - before.forward()).norm() > 0.1);
    mView->setTool(nullptr);
}

void SketchViewTest::wheelComesNearer()
{
    const double before = mView->camera().distance();
    QWheelEvent wheel(centre(), mView->mapToGlobal(centre()), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(mView.get(), &wheel);
    QVERIFY(mView->camera().distance() < before);
}

void SketchViewTest::comparesAlongTheDivider()
{
    const QPoint c = centre();
    mView->setComparison(double(c.x() + 30) / mView->width());
    const QColor left = pixel(c);
    QVERIFY2(left.red() <= left.blue() + 8, qPrintable(left.name())); // the sketch side: no surface
    const QPoint grip(c.x() + 30, 20);
    QTest::mousePress(mView.get(), Qt::LeftButton, {}, grip);
    QTest::mouseMove(mView.get(), grip - QPoint(30, 0));
    QTest::mouseMove(mView.get(), grip - QPoint(60, 0));
    QTest::mouseRelease(mView.get(), Qt::LeftButton, {}, grip - QPoint(60, 0));
    QVERIFY(std::abs(*mView->comparison() * mView->width() - (c.x() - 30)) < 2);
    // The right side shows the same pixels as without the comparison.
    const QColor right = pixel(c);
    QVERIFY2(right.red() > 2 * right.green(), qPrintable(right.name()));
}

QTEST_MAIN(SketchViewTest)
#include "sketch_view_test.moc"
