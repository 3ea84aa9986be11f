// Strokes on their way to and from the other apps.
#include "layerpainter/document/stroke_exchange.h"

#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "project/project_reader.h"
#include "project/project_writer.h"

#include <QtTest>

using namespace ductus;

namespace {

// A stroke from (0, 0, 0) to (1, 0, 0), twice as large and one higher, in centimetres; and a triangle.
Painting painting()
{
    StrokeShape shape;
    for (const float x : {0.f, 1.f}) {
        PaintedPoint point;
        point.position = {x, 0, 0};
        point.halfWidth = 0.1f + 0.1f * x;
        point.colour = {0.25f, 0.5f, 0.75f};
        shape.points.push_back(point);
    }
    MeshShape mesh;
    mesh.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.mesh.triangles = {{0, 1, 2}};
    mesh.vertexColours.assign(3, Eigen::Vector3f::Zero());
    const AddedStack stack = *addStack({}, "s");
    Placement placement;
    placement.scale = 2;
    placement.translation = {0, 1, 0};
    Painting result =
        addElements(stack.painting, stack.substrate,
                    {std::make_shared<const ElementShape>(shape), std::make_shared<const ElementShape>(mesh)},
                    0, placement)
            ->painting;
    result.metresPerUnit = 0.01;
    return result;
}

} // namespace

class StrokeExchangeTest : public QObject
{
    Q_OBJECT
private slots:
    void strokesAreCopiedWhereTheyStand();
    void pastedStrokesAreOneAction();
    void plainLinesGetTheBrush();
    void becomeASketch();
};

void StrokeExchangeTest::strokesAreCopiedWhereTheyStand()
{
    const Painting from = painting();
    const CopiedStrokes copied = copiedElements(from, elementsOf(from, from.stacks[0].substrate->id));
    QCOMPARE(copied.strokes.size(), std::size_t(1)); // nobody drew the mesh
    QCOMPARE(copied.metresPerUnit, 0.01);
    QCOMPARE(copied.strokes[0].line.points[1], Vec3(2, 1, 0));
    QVERIFY(std::abs(copied.strokes[0].halfWidths[1] - 0.4) < 1e-6);
    QVERIFY(std::abs(copied.strokes[0].line.pressure[0] - 0.5) < 1e-6);
    QCOMPARE(*copied.strokes[0].colour, Eigen::Vector3f(0.25f, 0.5f, 0.75f));
    QVERIFY(copiedElements(from, {}).strokes.empty());
}

void StrokeExchangeTest::pastedStrokesAreOneAction()
{
    const Painting from = painting();
    const LayerId layer = from.stacks[0].substrate->id;
    const CopiedStrokes copied = copiedElements(from, elementsOf(from, layer));
    const std::unique_ptr<QMimeData> data = mimeDataOf(copied);
    const act::Draw draw = drawnStrokes(*strokesFrom(data.get()), from, layer, 9.0, {0, 0, 0});
    const Result<PerformedAction> done = performed(from, draw);
    QVERIFY2(done.ok(), done ? "" : done.error().message().c_str());
    QCOMPARE(done->made.size(), std::size_t(1));
    const Element &pasted = done->painting.stacks[0].substrate->drawings[0].elements.back();
    const auto &points = std::get<StrokeShape>(*pasted.shape).points;
    QCOMPARE(points[1].position, Eigen::Vector3f(2, 1, 0));
    QVERIFY(std::abs(points[1].halfWidth - 0.4f) < 1e-6f);
    QCOMPARE(points[0].colour, Eigen::Vector3f(0.25f, 0.5f, 0.75f));
}

void StrokeExchangeTest::plainLinesGetTheBrush()
{
    CopiedStrokes plain;
    plain.strokes.resize(1);
    plain.strokes[0].line.points = {{0, 0, 0}, {1, 0, 0}}; // metres
    plain.strokes[0].line.pressure = {0.5, 1.0};
    const Painting to = painting();
    const act::Draw draw = drawnStrokes(plain, to, to.stacks[0].substrate->id, 3.0, {1, 0, 0});
    const auto &points = std::get<StrokeShape>(*draw.strokes[0]).points;
    QCOMPARE(points[1].position, Eigen::Vector3f(100, 0, 0));
    QCOMPARE(points[0].halfWidth, 1.5f);
    QCOMPARE(points[1].colour, Eigen::Vector3f(1, 0, 0));
}

void StrokeExchangeTest::becomeASketch()
{
    const Painting from = painting();
    const Project project =
        sketchProject(copiedElements(from, elementsOf(from, from.stacks[0].substrate->id)), "hat");
    const Result<SerializedProject> written = serializedProject(project);
    QVERIFY2(written.ok(), written ? "" : written.error().message().c_str());
    const Result<Project> again = parseProject(written->bytes, "hat.ductus");
    QVERIFY(again.ok());
    const auto sketch = again->documents[0].sketchSurface;
    QVERIFY(sketch);
    QCOMPARE(sketch->strokes.metresPerUnit, 0.01);
    QCOMPARE(sketch->strokes.strokes[0].points[1], Vec3(2, 1, 0));
    QCOMPARE(again->documents[0].name, std::string("hat"));
}

QTEST_APPLESS_MAIN(StrokeExchangeTest)
#include "stroke_exchange_test.moc"
