#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include "sketchsurfacer/ui/viewport/ambient_light.h"

#include <QtTest>

using namespace ductus;

namespace {

ViewMesh viewMeshOf(const TriangleMesh &mesh)
{
    ViewMesh view;
    view.mesh = std::make_shared<const TriangleMesh>(mesh);
    view.tree = std::make_shared<const RayTree>(mesh);
    view.shaded = shadedMesh(mesh, {});
    return view;
}

} // namespace

class SketchViewTest : public QObject
{
    Q_OBJECT
private slots:
    void showsWhatItIsGiven();
};

void SketchViewTest::showsWhatItIsGiven()
{
    SketchView view;
    view.resize(640, 480);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    Box3 box = boundingBox(mesh.vertices);
    view.setExtent(box, UpAxis::Y, 1.0);
    view.setMesh(SceneItem::Surface, viewMeshOf(mesh));
    view.setMode(ViewMode::Surface);
    view.setStrokes({{{{0, 0, 1}, {1, 0, 0}}, {{60, 140, 255, 255}}, 1.0}});
    view.setGround(groundShadow(mesh.vertices, UpAxis::Y, 0.5));
    QTRY_VERIFY(view.frameCount() > 0);
}

QTEST_MAIN(SketchViewTest)
#include "sketch_view_test.moc"
