#include "doodling/canvas/edit_doodle.h"
#include "doodling/canvas/edit_scene.h"

#include <QtTest>

using namespace ductus;

namespace {

Canvas placed()
{
    Canvas canvas;
    canvas.keyframes.positions = {{0, Vec2(10.0, 20.0), std::nullopt, false}};
    return canvas;
}

InkStroke lineOf(std::vector<Vec2> points)
{
    InkStroke ink;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ink.line.points.emplace_back(points[i].x(), points[i].y(), 0.0);
        ink.line.timeSeconds.push_back(double(i));
        ink.line.pressure.push_back(0.5);
    }
    ink.width = 0.02;
    return ink;
}

const InkStroke &inkOf(const Doodle &doodle, std::size_t index)
{
    return std::get<InkStroke>(*doodle.frames[0].marks[index]);
}

} // namespace

class EditTest : public QObject
{
    Q_OBJECT
private slots:
    void canvasesComeAndGo()
    {
        const DoodleScene one = *withCanvas({}, placed());
        const DoodleScene two = *withCanvas(one, placed());
        QCOMPARE(two.canvases[0].id.value, 0);
        QCOMPARE(two.canvases[1].id.value, 1);
        QCOMPARE(int(one.canvases.size()), 1); // as it was
        const DoodleScene swapped = *withMovedCanvas(two, CanvasId{0}, 1);
        QCOMPARE(swapped.canvases[1].id.value, 0);
        const DoodleScene left = *withoutCanvas(swapped, CanvasId{0});
        QCOMPARE(int(left.canvases.size()), 1);
        QVERIFY(left.find(CanvasId{1}) && !left.find(CanvasId{0}));
        QVERIFY(!withoutCanvas(left, CanvasId{0}).ok());
        QVERIFY(!withMovedCanvas(two, CanvasId{0}, 2).ok());
        Canvas changed = left.canvases[0];
        changed.name = "face";
        QCOMPARE(withChangedCanvas(left, changed)->canvases[0].name, std::string("face"));
        changed.id = CanvasId{9};
        QVERIFY(!withChangedCanvas(left, changed).ok());
        QVERIFY(!withCanvas({}, Canvas()).ok()); // nowhere
        changed.opacity = 2.0;
        QVERIFY(!withCanvas({}, changed).ok());
    }
    void keyframesStayInOrder()
    {
        Canvas canvas = placed();
        for (int frame : {30, 10, 20})
            canvas = *withPosition(canvas, {frame, Vec2(frame, 1.0), std::nullopt, false});
        canvas = *withPosition(canvas, {10, Vec2(11.0, 1.0), std::nullopt, false}); // in its place
        QCOMPARE(int(canvas.keyframes.positions.size()), 4);
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(canvas.keyframes.positions[i].frame, int(10 * i));
        QCOMPARE(canvas.keyframes.positions[1].pixel.x(), 11.0);
        canvas = *withMovedKeyframe(canvas, KeyframeKind::Position, 10, 25);
        QCOMPARE(canvas.keyframes.positions[2].frame, 25);
        QCOMPARE(canvas.keyframes.positions[2].pixel.x(), 11.0);
        QVERIFY(!withMovedKeyframe(canvas, KeyframeKind::Position, 25, 30).ok());
        QVERIFY(!withMovedKeyframe(canvas, KeyframeKind::Position, 10, 11).ok());
        canvas = *withInterpolation(canvas, KeyframeKind::Position, 25, true);
        QVERIFY(canvas.keyframes.positions[2].interpolatesNext);
        for (int frame : {0, 20, 25})
            canvas = *withoutKeyframe(canvas, KeyframeKind::Position, frame);
        QVERIFY(!withoutKeyframe(canvas, KeyframeKind::Position, 30).ok()); // the last one
        canvas = *withDepth(canvas, {5, 3.0});
        canvas = *withScale(canvas, {5, 2.0});
        canvas = *withTurn(canvas, {5, Eigen::Quaterniond(2.0, 0.0, 0.0, 0.0), false});
        QVERIFY(std::abs(canvas.keyframes.turns[0].worldFromCanvas.norm() - 1.0) < 1e-12);
        QVERIFY(!withInterpolation(canvas, KeyframeKind::Depth, 5, true).ok());
        QVERIFY(withoutKeyframe(canvas, KeyframeKind::Depth, 5).ok());
        QVERIFY(!withDepth(canvas, {5, -1.0}).ok());
        QVERIFY(!withScale(canvas, {5, 0.0}).ok());
        QVERIFY(!withPosition(canvas, {-1, Vec2(0.0, 0.0), std::nullopt, false}).ok());
    }
    void marksShareWhatDidNotChange()
    {
        const Doodle one = *withMark(Doodle(), 0, lineOf({{0, 0}, {1, 0}}));
        const Doodle two = *withMark(one, 0, TextMark{"hello"});
        QVERIFY(one.frames[0].marks[0] == two.frames[0].marks[0]);
        const Doodle moved = *withChangedMark(two, 0, two.frames[0].marks[1],
                                              movedMark(*two.frames[0].marks[1], Vec2(0.5, 0.25)));
        QCOMPARE(std::get<TextMark>(*moved.frames[0].marks[1]).place, Vec2(0.5, 0.25));
        QCOMPARE(int(withoutMark(two, 0, two.frames[0].marks[0])->frames[0].marks.size()), 1);
        QVERIFY(!withoutMark(one, 0, two.frames[0].marks[1]).ok());
        QVERIFY(!withMark(one, 1, TextMark{"hello"}).ok());
        QVERIFY(!withMark(one, 0, TextMark{""}).ok());
        QVERIFY(!withMark(one, 0, FilledShape{{{0, 0}, {1, 0}}}).ok());
        QVERIFY(!withMark(one, 0, ArrowMark{{{0, 0}}}).ok());
        QVERIFY(!withMark(one, 0, PictureMark{}).ok());
        InkStroke odd = lineOf({{0, 0}, {1, 0}});
        odd.line.pressure.pop_back();
        QVERIFY(!withMark(one, 0, odd).ok());
        QVERIFY(markAt(two.frames[0], {0.0, 0.0}, 0.01) == two.frames[0].marks[1]); // the topmost
        QVERIFY(markAt(two.frames[0], {0.9, 0.015}, 0.01) == two.frames[0].marks[0]);
        QVERIFY(!markAt(two.frames[0], {0.9, 0.2}, 0.01));
    }
    void theEraserCutsLines()
    {
        const Doodle line = *withMark(Doodle(), 0, lineOf({{0, 0}, {1, 0}}));
        const Doodle cut = *withErased(line, 0, {{0.5, 0.0}}, 0.09);
        QCOMPARE(int(cut.frames[0].marks.size()), 2);
        QCOMPARE(inkOf(cut, 0).line.points[0], Vec3(0, 0, 0));
        // Half the line's width is kept clear, too.
        QVERIFY((inkOf(cut, 0).line.points[1] - Vec3(0.4, 0, 0)).norm() < 1e-4);
        QVERIFY((inkOf(cut, 1).line.points[0] - Vec3(0.6, 0, 0)).norm() < 1e-4);
        QVERIFY(std::abs(inkOf(cut, 1).line.timeSeconds[0] - 0.6) < 1e-4);
        QCOMPARE(inkOf(cut, 1).line.pressure[0], 0.5);
        QCOMPARE(int(withErased(line, 0, {{0.0, 0.0}, {1.0, 0.0}}, 0.1)->frames[0].marks.size()), 0);
        const Doodle missed = *withErased(line, 0, {{0.5, 0.5}}, 0.1);
        QVERIFY(missed.frames[0].marks[0] == line.frames[0].marks[0]);
        const Doodle text = *withMark(line, 0, TextMark{"hello", {0.0, 0.5}});
        QCOMPARE(int(withErased(text, 0, {{-0.5, 0.3}, {0.5, 0.7}}, 0.02)->frames[0].marks.size()), 1);
        QVERIFY(!withErased(line, 0, {}, 0.1).ok());
    }
    void framesOfADoodle()
    {
        const Doodle start = *withMark(Doodle(), 0, TextMark{"a"});
        const Doodle two = *withInsertedFrame(start, 1, 3);
        QCOMPARE(two.frames[1].hold, 3);
        const Doodle three = *withDuplicatedFrame(two, 0);
        QVERIFY(three.frames[1].marks == three.frames[0].marks);
        const Doodle moved = *withMovedFrame(three, 2, 0);
        QCOMPARE(moved.frames[0].hold, 3);
        QCOMPARE(withHold(moved, 1, 4)->frames[1].hold, 4);
        QVERIFY(!withHold(moved, 1, 0).ok());
        QVERIFY(!withHold(moved, 3, 1).ok());
        QCOMPARE(int(withoutFrame(moved, 0)->frames.size()), 2);
        QVERIFY(!withoutFrame(start, 0).ok());
        QVERIFY(!withInsertedFrame(start, 3, 1).ok());
    }
};

QTEST_APPLESS_MAIN(EditTest)
#include "edit_test.moc"
