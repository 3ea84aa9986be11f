#include "support/sample_sketches.h"

#include <QTemporaryDir>
#include <QtTest>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

using namespace ductus;

namespace {

std::string contentOf(const std::filesystem::path &path)
{
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return stream ? text.str() : std::string();
}

const std::filesystem::path bundled = std::filesystem::path(DUCTUS_SOURCE_DIR) / "resources/samples";

} // namespace

class SampleSketchesTest : public QObject
{
    Q_OBJECT
private slots:
    void bundledFilesAreTheGeneratedOnes();
    void nothingElseIsBundled();
    void theListTellsTheTruth();
    void coordinatesSurviveTheText();
    void meshesAreWrittenOnRequest();
    void aFolderThatCannotBeMadeIsAnError();
};

void SampleSketchesTest::bundledFilesAreTheGeneratedOnes()
{
    for (const SampleFile &file : sampleFiles())
        QVERIFY2(contentOf(bundled / file.name) == file.content,
                 (file.name + " differs from what make_samples writes: run make_samples resources/samples")
                     .c_str());
}

void SampleSketchesTest::nothingElseIsBundled()
{
    std::set<std::string> expected, found;
    for (const SampleFile &file : sampleFiles())
        expected.insert(file.name);
    for (const auto &entry : std::filesystem::directory_iterator(bundled))
        if (entry.path().extension() == ".curves")
            found.insert(entry.path().filename().string());
    for (const std::string &name : found)
        QVERIFY2(expected.count(name) == 1, name.c_str());
}

void SampleSketchesTest::theListTellsTheTruth()
{
    const auto list = nlohmann::json::parse(contentOf(bundled / "samples.json"));
    QCOMPARE(list["version"].get<int>(), 1);
    QCOMPARE(list["samples"].size(), sampleSketches().size());
    for (const auto &entry : list["samples"]) {
        // Blocks of "v COUNT" and COUNT lines of three numbers, and nothing else.
        std::istringstream text(contentOf(bundled / entry["file"].get<std::string>()));
        std::string letter;
        int count = 0, strokes = 0;
        while (text >> letter >> count) {
            QCOMPARE(letter, std::string("v"));
            QVERIFY(count >= 2);
            double value = 0.0;
            for (int i = 0; i < 3 * count; ++i)
                QVERIFY(text >> value && std::abs(value) < 2.0);
            ++strokes;
        }
        QVERIFY(text.eof());
        QCOMPARE(strokes, entry["strokes"].get<int>());
        QVERIFY(!entry["title"].get<std::string>().empty() && !entry["lesson"].get<std::string>().empty());
        QCOMPARE(entry["boundaryStrokes"].empty(), !entry["open"].get<bool>());
        for (const auto &id : entry["boundaryStrokes"])
            QVERIFY(id.get<int>() >= 0 && id.get<int>() < strokes);
        if (!entry["symmetry"].is_null())
            QCOMPARE(entry["symmetry"].size(), std::size_t(4));
    }
}

void SampleSketchesTest::coordinatesSurviveTheText()
{
    StrokeSet set;
    set.strokes.push_back(
        {StrokeId{0}, StrokeRole::Surface, {Vec3(0.123456, -1e-9, -2.5), Vec3(1, 2, 3)}, {}, {}});
    QCOMPARE(curvesText(set), std::string("v 2\n0.12346 0.00000 -2.50000\n1.00000 2.00000 3.00000\n"));
}

void SampleSketchesTest::meshesAreWrittenOnRequest()
{
    QTemporaryDir folder;
    const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "neu/模型";
    QVERIFY(writeSamples(path, true).ok());
    const SampleSketch &sample = sampleSketches().front();
    QVERIFY(contentOf(path / sample.fileName()) == contentOf(bundled / sample.fileName()));
    const std::string obj = contentOf(path / (sample.id + "-truth.obj"));
    const Solid solid = sample.makeSolid();
    QCOMPARE(std::count(obj.begin(), obj.end(), '\n'),
             std::ptrdiff_t(solid.mesh.vertexCount() + solid.mesh.triangleCount()));
}

void SampleSketchesTest::aFolderThatCannotBeMadeIsAnError()
{
    QTemporaryDir folder;
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "file";
    std::ofstream(file) << "in the way";
    const auto written = writeSamples(file / "samples", false);
    QVERIFY(!written.ok());
    QCOMPARE(written.error().code, ErrorCode::WriteFailed);
}

QTEST_APPLESS_MAIN(SampleSketchesTest)
#include "sample_sketches_test.moc"
