#include "formats/paintings/painting_readers.h"

#include "support/quill_sample.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace ductus;

namespace {

Result<PaintingFile> readSample(const QuillSample &sample, const PaintingReadOptions &options = {})
{
    const auto json = memorySource(sample.json, "Quill.json");
    const auto qbin = memorySource(sample.qbin, "Quill.qbin");
    return readQuill(*json, qbin.get(), options, {});
}

/// A sample with one paint layer of one drawing at \a place.
QuillSample oneDrawing(const QuillData &data, std::uint64_t place)
{
    return {quillSceneText(quillLayerText("Paint", "Paint", quillDrawingsText({place}, "\"0\""))),
            data.bytes};
}

QString all(const std::vector<std::string> &lines)
{
    QString text;
    for (const std::string &line : lines)
        text += QString::fromStdString(line) + "\n";
    return text;
}

template <typename T>
void overwrite(std::string &bytes, std::size_t offset, T value)
{
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

} // namespace

class QuillReaderTest : public QObject
{
    Q_OBJECT
private slots:
    void readsTheTree();
    void readsStrokesInOrder();
    void keepsOnlyDrawingsThatFramesShow();
    void readsKeys();
    void composesTransforms();
    void readsPictures();
    void reportsWhatItSkips();
    void countsPlacesToStandApart();
    void saysThatTheDataIsMissing();
    void sharesDrawingsOfOnePlace();
    void clampsWithANote();
    void refusesDamagedScenes_data();
    void refusesDamagedScenes();
    void refusesDamagedData_data();
    void refusesDamagedData();
    void everyCutIsAnError();
    void stopsWhenCancelled();
    void respectsTheLimit();
};

void QuillReaderTest::readsTheTree()
{
    const auto file = readSample(quillSample());
    QVERIFY2(file.ok(), file.ok() ? "" : file.error().message().c_str());
    QCOMPARE(file->title, std::string("Sample"));
    QCOMPARE(file->layers.size(), std::size_t(6));
    const char *const paths[] = {"Root",           "Root/Still", "Root/Moved", "Root/Moved/Frames",
                                 "Root/Reference", "Root/Music"};
    for (int i = 0; i < 6; ++i) {
        QCOMPARE(file->pathOf(i), std::string(paths[i]));
        QVERIFY(file->layers[std::size_t(i)].parent < i);
    }
    QCOMPARE(file->layers[2].opacity, 0.5);
    QVERIFY(file->background.has_value());
    QCOMPARE(*file->background, Eigen::Vector3f(0.5f, 0.25f, 1.f));
    QCOMPARE(file->report.layers, 6);
}

void QuillReaderTest::readsStrokesInOrder()
{
    const auto file = readSample(quillSample());
    QVERIFY(file.ok());
    const PaintingFileLayer &still = file->layers[1];
    QCOMPARE(still.drawings.size(), std::size_t(1));
    QCOMPARE(still.drawings[0]->strokes.size(), std::size_t(2));
    const PaintingFileStroke &stroke = still.drawings[0]->strokes[1];
    QCOMPARE(stroke.id, 1u);
    QCOMPARE(stroke.section, PaintingFileSection::Round);
    QVERIFY(stroke.fadesSeenFromAside);
    QVERIFY(!still.drawings[0]->strokes[0].fadesSeenFromAside);
    QCOMPARE(stroke.points.size(), std::size_t(5));
    const PaintingFilePoint &point = stroke.points[2];
    QCOMPARE(point.position, Eigen::Vector3f(1, 0, 2));
    QCOMPARE(point.normal, Eigen::Vector3f(0, 1, 0));
    QCOMPARE(point.viewDirection, Eigen::Vector3f(0, 0, -1));
    QCOMPARE(point.colour, Eigen::Vector3f(0.25f, 0.5f, 0.75f));
    QCOMPARE(point.opacity, 1.f);
    QCOMPARE(point.halfWidth, 0.125f);
    QCOMPARE(stroke.points.front().halfWidth, 0.f);
}

void QuillReaderTest::keepsOnlyDrawingsThatFramesShow()
{
    const auto file = readSample(quillSample());
    QVERIFY(file.ok());
    const PaintingFileLayer &layer = file->layers[3];
    // Frames 3, 0, 0, 2 of four drawings: number 1 is not read and the rest close ranks.
    QCOMPARE(layer.frames, (std::vector<int>{2, 0, 0, 1}));
    QCOMPARE(layer.drawings.size(), std::size_t(3));
    QCOMPARE(layer.drawings[2]->strokes[0].section, PaintingFileSection::Cube);
    QCOMPARE(layer.drawings[1]->strokes[0].section, PaintingFileSection::Ellipse);
    QCOMPARE(layer.drawings[0]->strokes[0].section, PaintingFileSection::Ribbon);
    QCOMPARE(layer.framesPerSecond, 12.0);
    QCOMPARE(file->report.strokes, 5);
    QCOMPARE(file->report.points, std::int64_t(10 + 9));

    PaintingReadOptions still;
    still.firstFrameOnly = true;
    const auto first = readSample(quillSample(), still);
    QVERIFY(first.ok());
    QCOMPARE(first->layers[3].frames, std::vector<int>{0});
    QCOMPARE(first->layers[3].drawings.size(), std::size_t(1));
    QCOMPARE(first->layers[3].drawings[0]->strokes[0].section, PaintingFileSection::Cube);
    QCOMPARE(first->report.drawings, 2);
}

void QuillReaderTest::readsKeys()
{
    const auto file = readSample(quillSample());
    QVERIFY(file.ok());
    const PaintingFileAnimation &animation = file->layers[2].animation;
    QVERIFY(animation.hasOwnTimeline);
    QCOMPARE(animation.durationSeconds, 2.0);
    QCOMPARE(animation.startOffsetSeconds, 1.0);
    QCOMPARE(animation.repeatCount, 3);
    QCOMPARE(animation.visibility.size(), std::size_t(1));
    QCOMPARE(animation.visibility[0].value, false);
    QCOMPARE(animation.opacity[0].timeSeconds, 0.5);
    QCOMPARE(animation.opacity[0].interpolation, PaintingFileInterpolation::Linear);
    QCOMPARE(animation.transform.size(), std::size_t(2)); // in order of time
    QCOMPARE(animation.transform[0].interpolation, PaintingFileInterpolation::EaseIn);
    QCOMPARE(animation.transform[1].value.scale, 3.0);
    QCOMPARE(animation.transform[1].timeSeconds, 1.0);
}

void QuillReaderTest::composesTransforms()
{
    const auto file = readSample(quillSample());
    QVERIFY(file.ok());
    const Eigen::Affine3d sceneFromLayer = file->sceneFromLayer(3);
    // Flip x, times 2, a quarter turn about y (x to -z), then moved.
    const Eigen::Vector3d image = sceneFromLayer * Eigen::Vector3d(1, 5, 0);
    QVERIFY((image - Eigen::Vector3d(1, 12, 5)).norm() < 1e-12);
    QVERIFY(sceneFromLayer.linear().determinant() < 0);
    QVERIFY(file->isShown(3));
}

void QuillReaderTest::readsPictures()
{
    const auto file = readSample(quillSample());
    QVERIFY(file.ok());
    const PaintingFileLayer &layer = file->layers[4];
    QVERIFY(layer.picture.has_value());
    QCOMPARE(layer.picture->width, 3);
    QCOMPARE(layer.picture->height, 2);
    QCOMPARE(layer.picture->at(1, 1), (Rgba{84, 91, 98, 255}));
    QCOMPARE(layer.pictureType, std::string("2D"));

    PaintingReadOptions small;
    small.maxPicturePixels = 5;
    const auto without = readSample(quillSample(), small);
    QVERIFY(without.ok());
    QVERIFY(!without->layers[4].picture);
    QVERIFY(all(without->report.skipped).contains("Root/Reference: the picture of 3 x 2 pixels"));
}

void QuillReaderTest::reportsWhatItSkips()
{
    const auto file = readSample(quillSample());
    QVERIFY(file.ok());
    QCOMPARE(all(file->report.skipped), QString("Root/Moved/Frames: 1 drawing that no frame shows\n"
                                                "Root/Music: Sound layers are not imported\n"));
    QVERIFY(file->report.notes.empty());
    QCOMPARE(file->report.unseenSkips, 0);
}

// It is skipped like the others, but no picture misses it.
void QuillReaderTest::countsPlacesToStandApart()
{
    const QuillSample sample{quillSceneText(quillLayerText("Here", "Viewpoint", "\"Type\":0") + ",\n" +
                                            quillLayerText("Music", "Sound", "\"Gain\":1")),
                             QuillData().bytes};
    const auto file = readSample(sample);
    QVERIFY(file.ok());
    QCOMPARE(all(file->report.skipped), QString("Root/Here: Viewpoint layers are not imported\n"
                                                "Root/Music: Sound layers are not imported\n"));
    QCOMPARE(file->report.unseenSkips, 1);
}

void QuillReaderTest::saysThatTheDataIsMissing()
{
    const QuillSample sample = quillSample();
    const auto json = memorySource(sample.json, "Quill.json");
    const auto file = readQuill(*json, nullptr, {}, {});
    QVERIFY(!file.ok());
    QCOMPARE(file.error().code, ErrorCode::FileNotFound);
    QVERIFY(QString::fromStdString(file.error().problem).contains("Quill.qbin"));
}

void QuillReaderTest::sharesDrawingsOfOnePlace()
{
    QuillData data;
    const std::uint64_t place = data.addDrawing(2, 4, 0);
    const std::string paint = quillDrawingsText({place, place}, "0,1");
    const auto file = readSample(
        {quillSceneText(quillLayerText("A", "Paint", paint) + "," + quillLayerText("B", "Paint", paint)),
         data.bytes});
    QVERIFY(file.ok());
    QCOMPARE(file->report.drawings, 1);
    QCOMPARE(file->layers[1].drawings[0], file->layers[2].drawings[1]);
}

void QuillReaderTest::clampsWithANote()
{
    QuillData data;
    const std::uint64_t place = data.addDrawing(77, 3, 0);
    overwrite(data.bytes, place + 44 + 36, 1.5f);      // red of the first point
    overwrite(data.bytes, place + 44 + 56 + 52, -1.f); // width of the second
    const auto file = readSample(oneDrawing(data, place));
    QVERIFY(file.ok());
    const PaintingFileStroke &stroke = file->layers[1].drawings[0]->strokes[0];
    QCOMPARE(stroke.points[0].colour[0], 1.f);
    QCOMPARE(stroke.points[1].halfWidth, 0.f);
    QCOMPARE(stroke.section, PaintingFileSection::Round);
    const QString notes = all(file->report.notes);
    QVERIFY2(notes.contains("2 points"), qPrintable(notes));
    QVERIFY2(notes.contains("1 strokes have a brush that is not known"), qPrintable(notes));
}

void QuillReaderTest::refusesDamagedScenes_data()
{
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("part"); // of the message
    const auto paint = [](const std::string &implementation, const std::string &more = "") {
        return QString::fromStdString(quillSceneText(quillLayerText("P", "Paint", implementation, more)));
    };
    QTest::newRow("empty") << ""
                           << "Quill.json:1";
    QTest::newRow("no JSON") << "{\n\"a\": 1,\n\"b\": inf}"
                             << "Quill.json:3";
    QTest::newRow("number") << "{\n\"b\": 1e999}"
                            << "Quill.json:2";
    QTest::newRow("other JSON") << "[1,2]"
                                << "no Sequence";
    QTest::newRow("no root") << "{\"Sequence\":{}}"
                             << "no RootLayer";
    QTest::newRow("forged root") << "{\"Sequence\":{\"RootLayer\":0}}"
                                 << "no RootLayer";
    QTest::newRow("paint as root") << QString::fromStdString("{\"Sequence\":{\"RootLayer\":" +
                                                             quillLayerText("P", "Paint", "") + "}}")
                                   << "no group";
    QTest::newRow("child") << QString::fromStdString(quillSceneText("7")) << "no layer";
    QTest::newRow("opacity") << paint("", ",\"Opacity\":\"much\"") << "Opacity is no number";
    QTest::newRow("rotation") << paint("", ",\"Transform\":{\"Rotation\":[1,2,3]}") << "Rotation";
    QTest::newRow("flip") << paint("", ",\"Transform\":{\"Flip\":\"W\"}") << "Flip";
    QTest::newRow("matrix") << paint("", ",\"Transform\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]") << "matrices";
    QTest::newRow("huge") << paint("", ",\"Transform\":{\"Scale\":1e200}") << "beyond all bounds";
    QTest::newRow("offset short") << paint("\"Drawings\":[{\"DataFileOffset\":\"8\"}]") << "hexadecimal";
    QTest::newRow("offset letters") << paint("\"Drawings\":[{\"DataFileOffset\":\"0000000g\"}]")
                                    << "hexadecimal";
    QTest::newRow("frame outside") << paint("\"Drawings\":[{\"DataFileOffset\":\"00000008\"}],\"Frames\":[1]")
                                   << "Frames";
    QTest::newRow("frame negative") << paint(
                                           "\"Drawings\":[{\"DataFileOffset\":\"00000008\"}],\"Frames\":[-1]")
                                    << "Frames";
    QTest::newRow("offset outside")
        << paint("\"Drawings\":[{\"DataFileOffset\":\"ffffffffffffffff\"}],\"Frames\":[0]")
        << "byte 18446744073709551615";
    QTest::newRow("offset in header")
        << paint("\"Drawings\":[{\"DataFileOffset\":\"00000004\"}],\"Frames\":[0]") << "header";
    QString deep;
    for (int i = 0; i < 100000; ++i)
        deep += "[";
    QTest::newRow("deep") << deep << "nested too deeply";
}

void QuillReaderTest::refusesDamagedScenes()
{
    QFETCH(QString, json);
    QFETCH(QString, part);
    const auto file = readSample({json.toStdString(), std::string(64, '\0')});
    QVERIFY(!file.ok());
    const QString message = QString::fromStdString(file.error().message());
    QVERIFY2(message.contains(part), qPrintable(message));
    QVERIFY2(message.contains("Quill."), qPrintable(message));
    QVERIFY(!file.error().remedy.empty());
}

void QuillReaderTest::refusesDamagedData_data()
{
    QTest::addColumn<int>("at"); // behind the drawing's beginning
    QTest::addColumn<quint32>("value");
    QTest::addColumn<QString>("part");
    QTest::newRow("strokes") << 0 << 0xffffffffu << "byte 8: ";
    QTest::newRow("one stroke more") << 0 << 2u << "byte";
    QTest::newRow("points") << 40 << 0xffffffffu << "byte 48: ";
    QTest::newRow("one point more") << 40 << 6u << "byte 48: ";
    QTest::newRow("nan position") << 44 << 0x7fc00000u << "byte 52: ";
    QTest::newRow("inf width") << 44 + 56 + 52 << 0x7f800000u << "byte 108: ";
    QTest::newRow("huge position") << 44 << 0x7f000000u << "byte 52: ";
}

void QuillReaderTest::refusesDamagedData()
{
    QFETCH(int, at);
    QFETCH(quint32, value);
    QFETCH(QString, part);
    QuillData data;
    const std::uint64_t place = data.addDrawing(2, 5, 0);
    overwrite(data.bytes, std::size_t(place) + std::size_t(at), value);
    const auto file = readSample(oneDrawing(data, place));
    QVERIFY(!file.ok());
    const QString message = QString::fromStdString(file.error().message());
    QVERIFY2(message.startsWith("Quill.qbin: " + part), qPrintable(message));
}

void QuillReaderTest::everyCutIsAnError()
{
    QuillData data;
    const std::uint64_t place = data.addDrawing(2, 3, 0, 2);
    const QuillSample whole = oneDrawing(data, place);
    QVERIFY(readSample(whole).ok());
    for (std::size_t size = 0; size < whole.qbin.size(); ++size)
        QVERIFY2(!readSample({whole.json, whole.qbin.substr(0, size)}).ok(), std::to_string(size).c_str());
    const std::size_t end = whole.json.size() - 1; // the last is a line end
    for (std::size_t size = 0; size < end; ++size)
        QVERIFY2(!readSample({whole.json.substr(0, size), whole.qbin}).ok(), std::to_string(size).c_str());
}

void QuillReaderTest::stopsWhenCancelled()
{
    const QuillSample sample = quillSample();
    const auto json = memorySource(sample.json, "Quill.json");
    const auto qbin = memorySource(sample.qbin, "Quill.qbin");
    const std::atomic<bool> cancelled = true;
    const auto file = readQuill(*json, qbin.get(), {}, JobControl(&cancelled, {}));
    QVERIFY(!file.ok());
    QVERIFY(file.error().isCancelled());
}

void QuillReaderTest::respectsTheLimit()
{
    PaintingReadOptions options;
    options.maxPoints = 19;
    QVERIFY(readSample(quillSample(), options).ok());
    options.maxPoints = 18;
    const auto file = readSample(quillSample(), options);
    QVERIFY(!file.ok());
    QCOMPARE(file.error().code, ErrorCode::TooLarge);
}

QTEST_APPLESS_MAIN(QuillReaderTest)
#include "quill_reader_test.moc"
