#include "painting/import/painting_import.h"

#include "painting/scene/painting_check.h"
#include "support/quill_sample.h"

#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

Result<PaintingFile> sampleFile()
{
    QTemporaryDir dir;
    const fs::path folder = dir.path().toStdString();
    const QuillSample sample = quillSample();
    std::ofstream(folder / "Quill.json", std::ios::binary) << sample.json;
    std::ofstream(folder / "Quill.qbin", std::ios::binary) << sample.qbin;
    return readPainting(folder, {}, {});
}

} // namespace

class PaintingImportTest : public QObject
{
    Q_OBJECT
private slots:
    void everyPaintLayerBecomesAStack();
    void strokesStandWhereTheyStood();
    void inheritsFromGroups();
    void layersOfOneNameAreToldByTheirGroups();
    void saysWhatItCannotExpress();
    void refusesFlatTransforms();
    void importsRealSketches();
};

void PaintingImportTest::everyPaintLayerBecomesAStack()
{
    const auto imported = importPainting(*sampleFile());
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().message().c_str());
    const Painting &painting = imported->painting;
    QVERIFY(checkPainting(painting).ok());
    QCOMPARE(painting.stacks.size(), std::size_t(2));
    QCOMPARE(painting.stacks[0].name, std::string("Still"));
    QCOMPARE(painting.stacks[0].substrate->elementCount(), 2);
    QVERIFY(painting.stacks[0].appearance.empty());
    const Layer &frames = *painting.stacks[1].substrate;
    QCOMPARE(frames.drawings.size(), std::size_t(3));
    QCOMPARE(frames.frames.drawingOfFrame, (std::vector<int>{2, 0, 0, 1}));
    const auto &stroke = std::get<StrokeShape>(*frames.drawingAt(0).elements[0].shape);
    QCOMPARE(stroke.section, StrokeSection::Cube);
    QCOMPARE(painting.pictures.size(), std::size_t(1));
    QCOMPARE(painting.pictures[0].image->width, 3);
}

void PaintingImportTest::strokesStandWhereTheyStood()
{
    const auto file = sampleFile();
    const auto imported = importPainting(*file);
    const Element &element = imported->painting.stacks[1].substrate->drawings[0].elements[0];
    QVERIFY(element.placement.mirrored);
    const Eigen::Vector3d p(1, 5, -2);
    QVERIFY((element.placement.matrix() * p - file->sceneFromLayer(3) * p).norm() < 1e-12);
    const auto &points = std::get<StrokeShape>(*element.shape).points;
    QCOMPARE(points[1].halfWidth, 0.125f);
    QCOMPARE(points[1].colour, Eigen::Vector3f(0.25f, 0.5f, 0.75f));
}

void PaintingImportTest::inheritsFromGroups()
{
    auto file = sampleFile();
    file->layers[3].opacity = 0.5; // in a group of 0.5
    file->layers[2].visible = false;
    const auto imported = importPainting(*file);
    const LayerProperties &properties = imported->painting.stacks[1].substrate->properties;
    QCOMPARE(properties.opacity, 0.25);
    QVERIFY(!properties.visible);
    QVERIFY(imported->painting.stacks[0].substrate->properties.visible);
}

void PaintingImportTest::layersOfOneNameAreToldByTheirGroups()
{
    auto file = sampleFile();
    file->layers[2].name = "Tree";
    file->layers[3].name = file->layers[1].name; // in that group; the other one stands below the root
    const auto imported = importPainting(*file);
    QVERIFY(imported.ok());
    QCOMPARE(imported->painting.stacks[0].name, std::string("Still"));
    QCOMPARE(imported->painting.stacks[1].name, std::string("Tree / Still"));
    QCOMPARE(imported->painting.stacks[1].substrate->name, std::string("Tree / Still"));
}

void PaintingImportTest::saysWhatItCannotExpress()
{
    const auto imported = importPainting(*sampleFile());
    QCOMPARE(imported->notes.size(), std::size_t(2));
    QVERIFY(imported->notes[0].starts_with("Root/Still: 1 strokes fade"));
    QVERIFY(imported->notes[1].starts_with("Root/Moved: its animation keys"));
}

void PaintingImportTest::refusesFlatTransforms()
{
    auto file = sampleFile();
    file->layers[2].transform.scale = 0;
    const auto imported = importPainting(*file);
    QVERIFY(!imported.ok());
    QCOMPARE(imported.error().place, std::string("Frames"));
}

void PaintingImportTest::importsRealSketches()
{
    const fs::path path = fs::path(DUCTUS_SHARED_DATA) / "tilt/Ink.tilt";
    if (!fs::exists(path))
        QSKIP("the folder with real .tilt files is not there");
    const auto imported = importPainting(*readPainting(path, {}, {}));
    QVERIFY(imported.ok());
    QCOMPARE(imported->painting.stacks[0].substrate->elementCount(), 67);
    QCOMPARE(imported->painting.metresPerUnit, 0.1);
}

QTEST_APPLESS_MAIN(PaintingImportTest)
#include "painting_import_test.moc"
