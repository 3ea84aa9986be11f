#include "formats/paintings/painting_readers.h"

#include "support/tilt_sample.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

namespace {

Result<PaintingFile> readText(const std::string &sketch, const std::string &metadata = tiltMetadata())
{
    const auto data = memorySource(sketch, "data.sketch");
    const auto json = memorySource(metadata, "metadata.json");
    return readTilt(*data, json.get(), {}, {});
}

} // namespace

class TiltReaderTest : public QObject
{
    Q_OBJECT
private slots:
    void readsStrokes();
    void readsExtrasAndLayers();
    void takesTheSkyItWasPaintedUnder();
    void doesWithoutMetadata();
    void refusesDamage_data();
    void refusesDamage();
    void everyCutIsAnError();
};

void TiltReaderTest::readsStrokes()
{
    const auto file = readText(tiltSketch());
    QVERIFY2(file.ok(), file.ok() ? "" : file.error().message().c_str());
    QCOMPARE(file->metresPerUnit, 0.1);
    const PaintingFileStroke &stroke = file->layers[1].drawings[0]->strokes[0];
    QCOMPARE(stroke.brush, std::string("aaaa"));
    QCOMPARE(stroke.points.size(), std::size_t(3));
    QCOMPARE(stroke.points[1].position, Eigen::Vector3f(1, 2, -3)); // right-handed
    QCOMPARE(stroke.points[1].normal, Eigen::Vector3f(0, 0, -1));
    QCOMPARE(stroke.points[1].halfWidth, 0.5f); // size 2, pressure 0.5
    QCOMPARE(stroke.points[1].colour[0], 1.f);
    QVERIFY(std::abs(stroke.points[1].colour[1] - 0.21404f) < 1e-4f); // linear
    QCOMPARE(stroke.pressure[2], 0.5f);
    QCOMPARE(stroke.timeSeconds[2], 2.0);
}

void TiltReaderTest::readsExtrasAndLayers()
{
    const auto file = readText(tiltSketch());
    QVERIFY(file.ok());
    QCOMPARE(file->layers.size(), std::size_t(3));
    QCOMPARE(file->pathOf(1), std::string("Sketch/Ground"));
    QCOMPARE(file->pathOf(2), std::string("Sketch/Sky"));
    QVERIFY(file->isShown(1) && !file->isShown(2));
    const PaintingFileStroke &stroke = file->layers[2].drawings[0]->strokes[0];
    QCOMPARE(stroke.brush, std::string("bbbb"));
    QCOMPARE(stroke.group, 7u);
    QCOMPARE(stroke.points[0].halfWidth, 1.5f); // three times the size
    QCOMPARE(file->report.strokes, 2);
    QCOMPARE(file->report.points, std::int64_t(6));
    QCOMPARE(file->report.notes.size(), std::size_t(1));
    const auto longer = readText(tiltSketch() + "rest");
    QVERIFY(longer.ok());
    QCOMPARE(longer->report.notes.back(), std::string("4 bytes after the last stroke were not read"));
}

void TiltReaderTest::takesTheSkyItWasPaintedUnder()
{
    const auto under = [](const char *environment, float red, float green = 0.5f) {
        TiltStroke stroke;
        stroke.red = red;
        std::string bytes = tiltStroke(stroke);
        bytes.replace(8, 4, tiltBytes(green)); // behind the brush and red
        return readText(tiltHeader(1) + bytes,
                        std::string("{\"BrushIndex\":[\"aaaa\"],\"EnvironmentPreset\":") + environment + "}");
    };
    const auto standard = under("\"ab080599-e465-4a6d-8587-43bf495af68b\"", 1);
    QVERIFY(standard.ok());
    QVERIFY(standard->background.has_value());
    QVERIFY(std::abs((*standard->background)[0] - 0.0212f) < 1e-3f); // 40 of 255, linear
    QVERIFY((*standard->background)[2] > (*standard->background)[0]);
    const auto bright = under("\"580b4529-ac50-4fe9-b8d2-635765a14893\"", 1);
    QVERIFY(bright.ok() && bright->background == Eigen::Vector3f(0, 0, 0));
    // Nobody would see it.
    const auto dark = under("\"580b4529-ac50-4fe9-b8d2-635765a14893\"", 0.02f, 0.02f);
    QVERIFY(dark.ok() && !dark->background.has_value());
    QVERIFY(dark->report.notes[0].find("\"Black\"") != std::string::npos);
    for (const char *strange : {"\"nowhere\"", "7", "null"}) {
        const auto file = under(strange, 1);
        QVERIFY(file.ok() && !file->background.has_value());
    }
}

void TiltReaderTest::doesWithoutMetadata()
{
    const std::string sketch = tiltSketch();
    const auto data = memorySource(sketch, "data.sketch");
    const auto file = readTilt(*data, nullptr, {}, {});
    QVERIFY(file.ok());
    QCOMPARE(file->pathOf(2), std::string("Sketch/Layer 1"));
    QVERIFY(file->report.notes[0].find("metadata.json is missing") != std::string::npos);
}

void TiltReaderTest::refusesDamage_data()
{
    QTest::addColumn<QByteArray>("sketch");
    QTest::addColumn<QString>("part");
    const auto row = [](const char *name, const std::string &bytes, const char *part) {
        QTest::newRow(name) << QByteArray(bytes.data(), int(bytes.size())) << part;
    };
    const auto with = [](auto change) {
        TiltStroke stroke;
        change(stroke);
        return tiltHeader(1) + tiltStroke(stroke);
    };
    const std::string sound = tiltSketch();
    row("magic", "x" + sound.substr(1), "no sketch");
    row("version", sound.substr(0, 4) + tiltBytes(6) + sound.substr(8), "version 6");
    row("header size", sound.substr(0, 12) + tiltBytes(0x7fffffff) + sound.substr(16), "byte 16");
    row("strokes", tiltHeader(1000), "1000 strokes are announced");
    row("strokes below zero", tiltHeader(-1) + tiltStroke({}), "-1 strokes");
    row("brush", with([](TiltStroke &s) { s.brush = 2; }), "brush 2");
    row("brush below zero", with([](TiltStroke &s) { s.brush = -1; }), "brush -1");
    row("points below zero", with([](TiltStroke &s) { s.points = -5; }), "-5 points");
    row("size", with([](TiltStroke &s) { s.size = -1; }), "size of a stroke");
    row("size not a number", with([](TiltStroke &s) { s.size = NAN; }), "size of a stroke");
    row("colour", with([](TiltStroke &s) { s.red = NAN; }), "colour");
    row("extra too long", with([](TiltStroke &s) {
            s.strokeMask = 1u << 31;
            s.extras = tiltBytes(0x7fffffff);
        }),
        "byte");
    std::string infinite = with([](TiltStroke &) {});
    const float infinity = INFINITY;
    std::memcpy(infinite.data() + 24 + 36, &infinity, 4); // x of the first point
    row("position", infinite, "byte 60: ");
}

void TiltReaderTest::refusesDamage()
{
    QFETCH(QByteArray, sketch);
    QFETCH(QString, part);
    const auto file = readText(sketch.toStdString());
    QVERIFY(!file.ok());
    const QString message = QString::fromStdString(file.error().message());
    QVERIFY2(message.startsWith("data.sketch: byte") && message.contains(part), qPrintable(message));
    QVERIFY(!file.error().remedy.empty());
    QVERIFY(!readText(tiltSketch(), "{\"BrushIndex\":[1]}").ok());
    QVERIFY(!readText(tiltSketch(), "[]").ok());
    QVERIFY(!readText(tiltSketch(), "").ok());
}

void TiltReaderTest::everyCutIsAnError()
{
    const std::string sketch = tiltSketch();
    for (std::size_t size = 0; size < sketch.size(); ++size)
        QVERIFY2(!readText(sketch.substr(0, size)).ok(), std::to_string(size).c_str());
}

QTEST_APPLESS_MAIN(TiltReaderTest)
#include "tilt_reader_test.moc"
