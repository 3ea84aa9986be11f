#include "formats/painting_file.h"

#include "support/quill_sample.h"

#include <zip.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>
#include <fstream>
#include <set>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

const fs::path data = fs::path(DUCTUS_SHARED_DATA) / "quill";
const fs::path tilts = fs::path(DUCTUS_SHARED_DATA) / "tilt";

void writeText(const fs::path &path, const std::string &bytes)
{
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
}

/// A zip of Quill's files below a folder, deflated.
std::string zipped(const QuillSample &sample, const fs::path &scratch)
{
    zip_t *zip = zip_open(scratch.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    const auto add = [&](const char *name, const std::string &bytes) {
        zip_source_t *source = zip_source_buffer(zip, bytes.data(), bytes.size(), 0);
        zip_set_file_compression(zip, zip_uint64_t(zip_file_add(zip, name, source, 0)), ZIP_CM_DEFLATE, 9);
    };
    add("flower/Quill.json", sample.json);
    add("flower/Quill.qbin", sample.qbin);
    zip_close(zip);
    std::ifstream stream(scratch, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool isSample(const Result<PaintingFile> &file)
{
    return file.ok() && file->report.strokes == 5 && file->report.points == 19 && file->report.pictures == 1;
}

QString messageOf(const Result<PaintingFile> &file)
{
    return file.ok() ? QString("it was read") : QString::fromStdString(file.error().message());
}

} // namespace

class PaintingFileTest : public QObject
{
    Q_OBJECT
private slots:
    void readsFolderFileAndArchive();
    void readsOffsetsInAnyOrderFromAnArchive();
    void namesWhatIsWrong();
    void damagedArchivesAreErrors();
    void readsLargeProjectsAsAStream();
    void readsRealProjects_data();
    void readsRealProjects();
    void readsTheTreeOfARealScene();
    void readsRealTilts_data();
    void readsRealTilts();
    void cutTiltsAreErrors();
};

void PaintingFileTest::readsFolderFileAndArchive()
{
    QTemporaryDir dir;
    const fs::path folder = fs::path(dir.path().toStdString()) / "Blüte 花";
    const QuillSample sample = quillSample();
    writeText(folder / "Quill.json", sample.json);
    writeText(folder / "Quill.qbin", sample.qbin);
    QVERIFY(isSample(readPainting(folder, {}, {})));
    QVERIFY(isSample(readPainting(folder / "", {}, {})));
    QVERIFY(isSample(readPainting(folder / "Quill.json", {}, {})));
    const std::string archive = zipped(sample, folder / "flower.quill");
    const auto fromFile = readPainting(folder / "flower.quill", {}, {});
    QVERIFY2(isSample(fromFile), qPrintable(messageOf(fromFile)));
    QVERIFY(isSample(parsePainting(archive, "flower.quill", {}, {})));
}

void PaintingFileTest::readsOffsetsInAnyOrderFromAnArchive()
{
    // The later layer's drawing lies before the earlier's, and a picture before both.
    QuillData blobs;
    const std::uint64_t picture = blobs.addPicture(300, 300);
    const std::uint64_t second = blobs.addDrawing(2, 3000, 5);
    const std::uint64_t first = blobs.addDrawing(2, 3000, 7);
    const std::string scene = quillSceneText(
        quillLayerText("A", "Paint", quillDrawingsText({first}, "0")) + "," +
        quillLayerText("P", "Picture", "\"Type\":\"2D\",\"DataFileOffset\":\"" + quillHex(picture) + "\"") +
        "," + quillLayerText("B", "Paint", quillDrawingsText({second}, "0")));
    QTemporaryDir dir;
    const std::string archive = zipped({scene, blobs.bytes}, fs::path(dir.path().toStdString()) / "a.quill");
    const auto file = parsePainting(archive, "a.quill", {}, {});
    QVERIFY2(file.ok(), qPrintable(messageOf(file)));
    QCOMPARE(file->layers[1].drawings[0]->strokes[0].points[0].position.z(), 7.f);
    QCOMPARE(file->layers[3].drawings[0]->strokes[0].points[0].position.z(), 5.f);
    QCOMPARE(file->layers[2].picture->at(299, 299)[2], std::uint8_t(7 * (300 * 300 * 3 - 1)));
}

void PaintingFileTest::namesWhatIsWrong()
{
    QTemporaryDir dir;
    const fs::path root = dir.path().toStdString();
    const auto missing = readPainting(root / "none.quill", {}, {});
    QVERIFY(!missing.ok());
    QCOMPARE(missing.error().code, ErrorCode::FileNotFound);
    const auto folder = readPainting(root, {}, {});
    QVERIFY(!folder.ok());
    QCOMPARE(folder.error().code, ErrorCode::Unsupported);
    writeText(root / "hat.curves", "v 2\n0 0 0\n1 1 1\n");
    const auto other = readPainting(root / "hat.curves", {}, {});
    QVERIFY(!other.ok());
    QVERIFY2(messageOf(other).startsWith("hat.curves: "), qPrintable(messageOf(other)));
    writeText(root / "empty.quill", "");
    QVERIFY(!readPainting(root / "empty.quill", {}, {}).ok());
    writeText(root / "alone" / "Quill.json", quillSample().json);
    const auto alone = readPainting(root / "alone", {}, {});
    QVERIFY(!alone.ok());
    QVERIFY2(messageOf(alone).contains("Quill.qbin, is missing"), qPrintable(messageOf(alone)));
}

void PaintingFileTest::damagedArchivesAreErrors()
{
    QTemporaryDir dir;
    const std::string archive = zipped(quillSample(), fs::path(dir.path().toStdString()) / "a.quill");
    for (std::size_t size = 0; size < archive.size(); size += 7)
        QVERIFY(!parsePainting(std::string_view(archive).substr(0, size), "cut.quill", {}, {}).ok());
    // Damage in the packed bytes themselves: never a crash, and never other strokes than those packed.
    for (std::size_t at = 40; at < archive.size() / 2; at += 3) {
        std::string damaged = archive;
        damaged[at] = char(damaged[at] ^ 0x55);
        const auto file = parsePainting(damaged, "damaged.quill", {}, {});
        QVERIFY(!file.ok() || file->report.strokes <= 5);
    }
}

void PaintingFileTest::readsLargeProjectsAsAStream()
{
    // 20000 layers with keys, one stroke each: the text is several times what one layer needs.
    QuillData blobs;
    std::string layers;
    const std::string keys = ",\"Animation\":{\"Keys\":{\"Transform\":[{\"Time\":\"0\",\"Value\":{"
                             "\"Rotation\":[0,0,0,1],\"Scale\":1,"
                             "\"Flip\":\"N\",\"Translation\":[0,0,0]},\"Interpolation\":\"Linear\"}]}}";
    for (int i = 0; i < 20000; ++i) {
        const std::uint64_t place = blobs.addDrawing(2, 20, float(i));
        layers += (i ? ",\n" : "") +
                  quillLayerText("L" + std::to_string(i), "Paint", quillDrawingsText({place}, "\"0\""), keys);
    }
    QTemporaryDir dir;
    const fs::path folder = dir.path().toStdString();
    writeText(folder / "Quill.json", quillSceneText(layers));
    writeText(folder / "Quill.qbin", blobs.bytes);
    QElapsedTimer timer;
    timer.start();
    const auto file = readPainting(folder, {}, {});
    qInfo("%.1f MB of text, %.1f MB of data: %.2f s", double(fs::file_size(folder / "Quill.json")) * 1e-6,
          double(blobs.bytes.size()) * 1e-6, double(timer.elapsed()) * 1e-3);
    QVERIFY2(file.ok(), qPrintable(messageOf(file)));
    QCOMPARE(file->report.strokes, 20000);
    QCOMPARE(file->report.points, std::int64_t(400000));
    QCOMPARE(file->layers[20000].drawings[0]->strokes[0].points[0].position.z(), 19999.f);
    QCOMPARE(file->layers[20000].animation.transform.size(), std::size_t(1));
}

void PaintingFileTest::readsRealProjects_data()
{
    QTest::addColumn<QString>("folder");
    QTest::addColumn<int>("points");
    QTest::addColumn<int>("section");
    QTest::newRow("line of cubes") << "btparker/CBrushLine" << 8 << int(PaintingFileSection::Cube);
    QTest::newRow("cylinder stroke") << "btparker/CCBrushStroke" << 31 << int(PaintingFileSection::Round);
}

void PaintingFileTest::readsRealProjects()
{
    QFETCH(QString, folder);
    QFETCH(int, points);
    QFETCH(int, section);
    const fs::path path = data / folder.toStdString();
    if (!fs::exists(path))
        QSKIP("the folder with real Quill projects is not there");
    const auto file = readPainting(path, {}, {});
    QVERIFY2(file.ok(), qPrintable(messageOf(file)));
    QCOMPARE(file->report.strokes, 1);
    QCOMPARE(file->report.points, std::int64_t(points));
    QVERIFY(file->report.notes.empty());
    const PaintingFileStroke &stroke = file->layers.back().drawings[0]->strokes[0];
    QCOMPARE(int(stroke.section), section);
    QCOMPARE(stroke.points.front().halfWidth, 0.f);
    QCOMPARE(stroke.points.back().halfWidth, 0.f);
    for (const PaintingFilePoint &point : stroke.points) {
        QVERIFY(std::abs(point.viewDirection.norm() - 1) < 1e-4f);
        QVERIFY(std::abs(point.normal.norm() - 1) < 1e-3f);
        QVERIFY(point.halfWidth <= 0.0101f);
    }
}

void PaintingFileTest::readsTheTreeOfARealScene()
{
    const fs::path path = data / "AIVaneer";
    if (!fs::exists(path))
        QSKIP("the folder with real Quill projects is not there");
    const auto whole = readPainting(path, {}, {});
    QVERIFY(!whole.ok()); // its Quill.qbin is not there
    QCOMPARE(whole.error().code, ErrorCode::FileNotFound);

    // The same tree above data of our own: as many empty drawings as its highest offset needs.
    std::ifstream stream(path / "Quill.json", std::ios::binary);
    const std::string json{std::istreambuf_iterator<char>(stream), {}};
    QTemporaryDir dir;
    const fs::path folder = dir.path().toStdString();
    writeText(folder / "Quill.json", json);
    writeText(folder / "Quill.qbin", "");
    fs::resize_file(folder / "Quill.qbin", 16u << 20); // zeros: drawings without strokes
    const auto file = readPainting(folder, {}, {});
    QVERIFY2(file.ok(), qPrintable(messageOf(file)));
    int groups = 0, paints = 0, others = 0;
    for (const PaintingFileLayer &layer : file->layers) {
        groups += layer.kind == PaintingFileLayerKind::Group;
        paints += layer.kind == PaintingFileLayerKind::Paint;
        others += layer.kind == PaintingFileLayerKind::Other;
    }
    QCOMPARE(groups, 5);
    QCOMPARE(paints, 6);
    QCOMPARE(others, 2);
    const PaintingFileLayer &animated = file->layers.back();
    QCOMPARE(animated.frames, (std::vector<int>{0, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 1, 1}));
    QCOMPARE(file->pathOf(int(file->layers.size()) - 1), std::string("Root/Untitled_swords_01/Paint"));
    QCOMPARE(file->report.skipped.size(), std::size_t(2));
}

void PaintingFileTest::readsRealTilts_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("strokes");
    QTest::addColumn<int>("points");
    QTest::addColumn<int>("brushes");
    QTest::addColumn<int>(
        "notes"); // the brushes, a sky too like the strokes; no byte left over, nothing clamped
    QTest::newRow("one stroke") << "OneStroke.tilt" << 1 << 4 << 1 << 1;
    QTest::newRow("simple") << "Simple.tilt" << 3 << 32 << 1 << 2;
    QTest::newRow("ink") << "Ink.tilt" << 67 << 1231 << 1 << 1;
    QTest::newRow("sketch1") << "sketch1.tilt" << 5 << 912 << 1 << 1; // it names two brushes
}

void PaintingFileTest::readsRealTilts()
{
    QFETCH(QString, name);
    QFETCH(int, strokes);
    QFETCH(int, points);
    QFETCH(int, brushes);
    QFETCH(int, notes);
    const fs::path path = tilts / name.toStdString();
    if (!fs::exists(path))
        QSKIP("the folder with real .tilt files is not there");
    const auto file = readPainting(path, {}, {});
    QVERIFY2(file.ok(), qPrintable(messageOf(file)));
    QCOMPARE(file->kind, PaintingFileKind::Tilt);
    QCOMPARE(file->report.strokes, strokes);
    QCOMPARE(file->report.points, std::int64_t(points));
    QCOMPARE(int(file->report.notes.size()), notes);
    QCOMPARE(file->layers.size(), std::size_t(2));
    std::set<std::string> used;
    for (const PaintingFileStroke &stroke : file->layers[1].drawings[0]->strokes) {
        used.insert(stroke.brush);
        QCOMPARE(stroke.pressure.size(), stroke.points.size());
        QCOMPARE(stroke.timeSeconds.size(), stroke.points.size());
        QVERIFY(std::is_sorted(stroke.timeSeconds.begin(), stroke.timeSeconds.end()));
        for (const PaintingFilePoint &point : stroke.points) {
            QVERIFY(std::abs(point.normal.norm() - 1) < 1e-3f);
            QVERIFY(point.position.norm() < 1000); // decimetres in a room
            QVERIFY(point.halfWidth >= 0 && point.halfWidth < 10);
        }
    }
    QCOMPARE(int(used.size()), brushes);
}

void PaintingFileTest::cutTiltsAreErrors()
{
    const fs::path path = tilts / "OneStroke.tilt";
    if (!fs::exists(path))
        QSKIP("the folder with real .tilt files is not there");
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    QVERIFY(parsePainting(bytes, "one.tilt", {}, {}).ok());
    for (std::size_t size = 0; size + 1 < bytes.size(); size += 101)
        QVERIFY(!parsePainting(std::string_view(bytes).substr(0, size), "cut.tilt", {}, {}).ok());
}

QTEST_APPLESS_MAIN(PaintingFileTest)
#include "painting_file_test.moc"
