// Strokes through the clipboard: all of it comes back, other programs get text, foreign data is refused.
#include "document/stroke_clipboard.h"

#include <QtTest>

using namespace ductus;

namespace {

CopiedStrokes sample()
{
    CopiedStrokes strokes;
    strokes.metresPerUnit = 0.01;
    strokes.upAxis = UpAxis::Z;
    CopiedStroke painted;
    painted.line.points = {{0, 0, 0}, {1.0 / 3.0, -2e-7, 1e6}};
    painted.line.pressure = {0.25, 1.0};
    painted.line.timeSeconds = {0.0, 0.1};
    painted.line.role = StrokeRole::Boundary;
    painted.halfWidths = {0.5, 0.125};
    painted.colour = Eigen::Vector3f(0.5f, 0.25f, 1.0f);
    painted.opacity = 0.75;
    CopiedStroke plain;
    plain.line.points = {{1, 2, 3}};
    strokes.strokes = {painted, plain};
    return strokes;
}

} // namespace

class StrokeClipboardTest : public QObject
{
    Q_OBJECT
private slots:
    void allOfItComesBack();
    void otherProgramsGetText();
    void refusesWhatNoAppWrote_data();
    void refusesWhatNoAppWrote();
    void unitsAndAxesAreAdapted();
};

void StrokeClipboardTest::allOfItComesBack()
{
    const std::unique_ptr<QMimeData> data = mimeDataOf(sample());
    QVERIFY(hasStrokes(data.get()));
    const Result<CopiedStrokes> again = strokesFrom(data.get());
    QVERIFY2(again.ok(), again ? "" : again.error().message().c_str());
    const CopiedStroke &painted = again->strokes[0], expected = sample().strokes[0];
    QCOMPARE(again->strokes.size(), std::size_t(2));
    QCOMPARE(again->metresPerUnit, 0.01);
    QCOMPARE(again->upAxis, UpAxis::Z);
    QVERIFY(!again->isFlat);
    QCOMPARE(painted.line.points[1], expected.line.points[1]);
    QCOMPARE(painted.line.pressure, expected.line.pressure);
    QCOMPARE(painted.line.timeSeconds, expected.line.timeSeconds);
    QCOMPARE(painted.line.role, StrokeRole::Boundary);
    QCOMPARE(painted.halfWidths, expected.halfWidths);
    QCOMPARE(*painted.colour, *expected.colour);
    QCOMPARE(painted.opacity, 0.75);
    QVERIFY(!again->strokes[1].colour && again->strokes[1].halfWidths.empty());
}

void StrokeClipboardTest::otherProgramsGetText()
{
    const QStringList lines = mimeDataOf(sample())->text().split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 5);
    QCOMPARE(lines[0], QString("v 2"));
    QCOMPARE(lines[1], QString("0 0 0"));
    QCOMPARE(lines[4], QString("1 2 3"));
}

void StrokeClipboardTest::refusesWhatNoAppWrote_data()
{
    QTest::addColumn<QByteArray>("text");
    const QByteArray head = R"({"schema":"strokes","version":1,"metresPerUnit":1,"upAxis":"y","flat":false,)";
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("no json") << QByteArray("v 2");
    QTest::newRow("newer") << QByteArray(R"({"schema":"strokes","version":2,"strokes":[]})");
    QTest::newRow("no strokes") << QByteArray(head + R"("strokes":[]})");
    QTest::newRow("no points") << QByteArray(head + R"("strokes":[{"role":"surface","points":[]}]})");
    QTest::newRow("two numbers") << QByteArray(head + R"("strokes":[{"role":"surface","points":[[1,2]]}]})");
    QTest::newRow("far away") << QByteArray(head +
                                            R"("strokes":[{"role":"surface","points":[[1e300,2,3]]}]})");
    QTest::newRow("one width short") << QByteArray(
        head + R"("strokes":[{"role":"surface","points":[[1,2,3],[1,2,4]],"halfWidths":[1]}]})");
    QTest::newRow("negative width") << QByteArray(
        head + R"("strokes":[{"role":"surface","points":[[1,2,3]],"halfWidths":[-1]}]})");
    QTest::newRow("odd role") << QByteArray(head + R"("strokes":[{"role":"hair","points":[[1,2,3]]}]})");
}

void StrokeClipboardTest::refusesWhatNoAppWrote()
{
    QFETCH(QByteArray, text);
    QMimeData data;
    data.setData(strokesMimeType(), text);
    QVERIFY(!strokesFrom(&data).ok());
    QVERIFY(!strokesFrom(nullptr).ok());
}

void StrokeClipboardTest::unitsAndAxesAreAdapted()
{
    CopiedStrokes strokes = sample(); // centimetres, z up
    strokes.strokes[1].line.points = {{100, 200, 300}};
    strokes.strokes[1].halfWidths = {10};
    const CopiedStrokes metres = inUnit(strokes, 1.0, UpAxis::Y);
    QVERIFY((metres.strokes[1].line.points[0] - Vec3(1, 3, -2)).norm() < 1e-12);
    QVERIFY(std::abs(metres.strokes[1].halfWidths[0] - 0.1) < 1e-12);
    const CopiedStrokes back = inUnit(metres, 0.01, UpAxis::Z);
    QVERIFY((back.strokes[1].line.points[0] - Vec3(100, 200, 300)).norm() < 1e-9);
}

QTEST_APPLESS_MAIN(StrokeClipboardTest)
#include "stroke_clipboard_test.moc"
