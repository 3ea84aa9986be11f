// Lines of a canvas on their way to and from the other apps.
#include "doodlestudio/document/stroke_exchange.h"

#include "doodling/canvas/edit_doodle.h"

#include <QtTest>

using namespace ductus;

class StrokeExchangeTest : public QObject
{
    Q_OBJECT
private slots:
    void linesComeBackWhereTheyWere();
    void strokesInSpaceAreSeenFromTheFront();
    void onlyLinesAreStrokes();
};

void StrokeExchangeTest::linesComeBackWhereTheyWere()
{
    InkStroke ink;
    ink.line.points = {{0.1, 0.2, 0.0}, {0.3, -0.1, 0.0}};
    ink.line.pressure = {0.5, 1.0};
    ink.line.timeSeconds = {0.0, 0.25};
    ink.colour = {200, 30, 60, 128};
    ink.width = 0.04;
    const Doodle doodle = *withMark({}, 0, ink);
    const std::unique_ptr<QMimeData> data = mimeDataOf(copiedLines(doodle.frames[0]));
    const std::vector<InkStroke> lines = inkStrokes(*strokesFrom(data.get()), {2, 1}, 9.0, {0, 0, 0, 255});
    QCOMPARE(lines.size(), std::size_t(1));
    QCOMPARE(lines[0].line.points[1], ink.line.points[1]);
    QCOMPARE(lines[0].line.pressure[0], 0.5);
    QCOMPARE(lines[0].line.timeSeconds, ink.line.timeSeconds);
    QCOMPARE(lines[0].colour, ink.colour);
    QVERIFY(std::abs(lines[0].width - 0.04) < 1e-12);
    const Result<Doodle> pasted = withLines(doodle, 0, lines);
    QVERIFY(pasted.ok());
    QCOMPARE(pasted->frames[0].marks.size(), std::size_t(2));
}

void StrokeExchangeTest::strokesInSpaceAreSeenFromTheFront()
{
    CopiedStrokes strokes;
    strokes.upAxis = UpAxis::Z;
    strokes.strokes.resize(1);
    strokes.strokes[0].line.points = {{10, 5, 0}, {14, 9, 2}}; // four wide, two high
    const std::vector<InkStroke> lines = inkStrokes(strokes, {2.0, 1.0}, 0.05, {1, 2, 3, 255});
    QVERIFY((lines[0].line.points[0] - Vec3(-0.8, 0.4, 0)).norm() < 1e-9); // left and low: y goes down
    QVERIFY((lines[0].line.points[1] - Vec3(0.8, -0.4, 0)).norm() < 1e-9);
    QCOMPARE(lines[0].width, 0.05);
    QCOMPARE(lines[0].colour, Rgba({1, 2, 3, 255}));
}

void StrokeExchangeTest::onlyLinesAreStrokes()
{
    const Doodle doodle = *withMark({}, 0, TextMark{"word"});
    QVERIFY(copiedLines(doodle.frames[0]).strokes.empty());
}

QTEST_APPLESS_MAIN(StrokeExchangeTest)
#include "stroke_exchange_test.moc"
