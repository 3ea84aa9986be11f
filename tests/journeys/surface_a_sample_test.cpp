// "I try one of the samples": every bundled sketch becomes a mesh in one of the formats, with report and
// picture.
#include "journeys/sketch_journey.h"

#include "formats/png_file.h"
#include "geometry/mesh_topology.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

using namespace ductus;
using Json = nlohmann::json;

namespace {

bool isNear(double a, double b, double share)
{
    return std::abs(a - b) <= share * std::max(std::abs(a), std::abs(b));
}

// Coordinates of STL and GLB are 32-bit floats, and equal corners are merged when they are read: near twins
// may merge.
bool isExact(const QString &extension)
{
    return extension != QLatin1String("stl") && extension != QLatin1String("glb");
}

// 0..359 [Smith 1978]; QColor would need QtGui.
int hueOf(const Rgba &p)
{
    const double r = p[0], g = p[1], b = p[2];
    const double high = std::max({r, g, b}), span = high - std::min({r, g, b});
    const double sixth = high == r ? (g - b) / span : high == g ? 2.0 + (b - r) / span : 4.0 + (r - g) / span;
    return int(60.0 * sixth + 360.0) % 360;
}

struct Coverage // shares of the pixels of one third of the picture
{
    double covered = 0.0;   // not the background
    double dark = 0.0;      // strokes
    double colourful = 0.0; // regions
    int hues = 0;           // of twelve, each with 0.2 % of the pixels or more
};

// The background is a soft vertical gradient with a soft shadow, so it is the pixels that differ clearly from
// the beginning of their row that are covered.
Coverage coverageOf(const Image &image, int third)
{
    const int width = image.width / 3;
    std::vector<int> hues(12);
    Coverage c;
    const double share = 1.0 / (double(width) * image.height);
    for (int y = 0; y < image.height; ++y) {
        const Rgba background = image.at(third * width, y);
        for (int x = third * width; x < (third + 1) * width; ++x) {
            const Rgba p = image.at(x, y);
            int difference = 0;
            for (int k = 0; k < 3; ++k)
                difference =
                    std::max(difference, std::abs(int(p[std::size_t(k)]) - int(background[std::size_t(k)])));
            c.covered += difference > 24 ? share : 0.0;
            const int high = std::max({p[0], p[1], p[2]}), low = std::min({p[0], p[1], p[2]});
            c.dark += high < 130 ? share : 0.0;
            if (high - low > 70) {
                c.colourful += share;
                ++hues[std::size_t(hueOf(p) / 30)];
            }
        }
    }
    for (int count : hues)
        c.hues += count * share >= 0.002;
    return c;
}

} // namespace

class SurfaceASampleTest : public QObject
{
    Q_OBJECT
private slots:
    void everySampleBecomesASurface_data();
    void everySampleBecomesASurface();
    void allFormatsHoldTheSameSurface();
    void groupsOfTheObjAreTheRegions();
    void pictureShowsSketchRegionsAndSurface();
    void quietSaysNothing();

private:
    QTemporaryDir mFolder;
    QString path(const QString &name) const { return mFolder.filePath(name); }
};

void SurfaceASampleTest::everySampleBecomesASurface_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QString>("vertices");
    QTest::addColumn<bool>("isClosed");
    // One in full size; the others as rough as is needed to be quick.
    QTest::newRow("car, glb") << "car"
                              << "glb"
                              << "12000" << true;
    QTest::newRow("bottle, stl") << "bottle"
                                 << "stl"
                                 << "4000" << true;
    QTest::newRow("bevelled-box, ply") << "bevelled-box"
                                       << "ply"
                                       << "4000" << true;
    QTest::newRow("bent-leaf, obj") << "bent-leaf"
                                    << "obj"
                                    << "4000" << false;
    QTest::newRow("computer-mouse, off") << "computer-mouse"
                                         << "off"
                                         << "4000" << true;
    QTest::newRow("table-lamp, obj") << "table-lamp"
                                     << "obj"
                                     << "4000" << true;
    QTest::newRow("iron, ply") << "iron"
                               << "ply"
                               << "4000" << true;
}

void SurfaceASampleTest::everySampleBecomesASurface()
{
    QFETCH(QString, id);
    QFETCH(QString, extension);
    QFETCH(QString, vertices);
    QFETCH(bool, isClosed);
    const QString in = samplePath(id), out = path(id + QLatin1Char('.') + extension);
    const QString reportPath = path(id + QLatin1String(".json")),
                  picturePath = path(id + QLatin1String(".png"));
    const ProgramRun run = runSketchSurfacer(surfaceArguments(
        in, out, {"--report", reportPath, "--picture", picturePath, "--proxy-vertices", vertices}));
    QVERIFY2(!run.crashed && run.exitCode == 0, run.told().constData());
    QVERIFY2(run.out.isEmpty(), "results go into files and words to stderr");
    QCOMPARE(run.messages().size(), 1); // the summary
    QVERIFY(run.messages().first().contains(out));

    const TriangleMesh mesh = meshOf(out);
    QCOMPARE(faultOfMesh(mesh), QString());
    const StrokeSet strokes = strokesOf(in);
    QCOMPARE(faultOfFit(strokes, mesh, 0.5), QString());
    const ManifoldReport manifold = manifoldReport(mesh);
    QCOMPARE(manifold.isClosed(), isClosed);

    const Json report = Json::parse(bytesOf(reportPath).toStdString(), nullptr, false);
    QVERIFY2(report.is_object(), bytesOf(reportPath).left(300).constData());
    QCOMPARE(report.at("schema").get<std::string>(), std::string("surface-report"));
    QCOMPARE(report.at("version").get<int>(), 1);
    QCOMPARE(report.at("input").get<std::string>(), (id + QLatin1String(".curves")).toStdString());
    QCOMPARE(report.at("strokes").get<int>(), int(strokes.strokes.size()));
    QCOMPARE(report.at("points").get<int>(), strokes.pointCount());
    QVERIFY(isNear(report.at("diagonal").get<double>(), strokes.box().diagonal(), 1e-5));
    QCOMPARE(report.at("options").at("seed").get<int>(), 1);

    const Json &told = report.at("mesh");
    QCOMPARE(told.at("manifold").get<bool>(), true);
    QCOMPARE(told.at("watertight").get<bool>(), isClosed);
    QCOMPARE(told.at("components").get<int>(), manifold.components);
    QVERIFY(isNear(told.at("area").get<double>(), surfaceArea(mesh), 1e-4));
    if (isExact(extension)) {
        QCOMPARE(told.at("vertices").get<int>(), mesh.vertexCount());
        QCOMPARE(told.at("triangles").get<int>(), mesh.triangleCount());
        QCOMPARE(told.at("borderEdges").get<int>(), manifold.borderEdges);
    }
    QVERIFY(!report.at("regions").empty());
    double regionArea = 0.0;
    for (const Json &region : report.at("regions")) {
        QVERIFY(region.at("degree").get<int>() >= 1);
        regionArea += region.at("area").get<double>();
    }
    QVERIFY(isNear(regionArea, surfaceArea(mesh), 1e-3));

    const Json &deviation = report.at("deviationPercent");
    const double median = deviation.at("median"), p95 = deviation.at("p95"), max = deviation.at("max");
    QVERIFY(median > 0.0 && median <= p95 && p95 <= max);
    QVERIFY(deviation.at("mean").get<double>() <= max);
    QVERIFY(report.at("strokeDeviationPercent").size() == strokes.strokes.size());
    double worst = 0.0;
    for (const Json &stroke : report.at("strokeDeviationPercent"))
        worst = std::max(worst, stroke.is_null() ? 0.0 : stroke.get<double>());
    QVERIFY(isNear(worst, max, 1e-5));

    const Json &energy = report.at("energy");
    QCOMPARE(energy.at("runs").size(), std::size_t(1));
    // Runs are judged on a simplified graph, the winner, polished, on the whole one: the same energy but for
    // what the proxy objects to, which clusters of vertices stand for roughly.
    const double polished = energy.at("total"), first = energy.at("runs").at(0);
    QVERIFY2(polished < 1.3 * first && polished > 0.5 * first,
             qPrintable(QString("%1 of %2").arg(polished).arg(first)));
    const Json &seconds = report.at("seconds");
    double sum = 0.0;
    for (const char *phase : {"proxy", "association", "segmentation", "extraction"})
        sum += seconds.at(phase).get<double>();
    const double total = seconds.at("total");
    QVERIFY(sum > 0.0 && sum <= total * 1.001 && total <= run.seconds + 0.01);

    const Result<Image> picture = readPng(picturePath.toStdString());
    QVERIFY2(picture.ok(), picture.ok() ? "" : picture.error().message().c_str());
    QVERIFY(picture->width >= 900 && picture->height >= 300);
    QVERIFY(coverageOf(*picture, 2).covered > 0.03);
}

void SurfaceASampleTest::allFormatsHoldTheSameSurface()
{
    const QStringList extensions = {"obj", "ply", "off", "stl", "glb"};
    std::vector<TriangleMesh> meshes;
    for (const QString &extension : extensions) {
        const QString out = path("same." + extension);
        const ProgramRun run = runSketchSurfacer(surfaceArguments(samplePath("bent-leaf"), out));
        QVERIFY2(run.exitCode == 0, run.told().constData());
        meshes.push_back(meshOf(out));
    }
    for (std::size_t i = 1; i < meshes.size(); ++i) {
        QVERIFY2(isNear(surfaceArea(meshes[i]), surfaceArea(meshes[0]), 1e-6),
                 qPrintable(extensions[int(i)]));
        const Box3 a = boundingBox(meshes[0].vertices), b = boundingBox(meshes[i].vertices);
        QVERIFY2((a.min - b.min).norm() + (a.max - b.max).norm() < 1e-6 * a.diagonal(),
                 qPrintable(extensions[int(i)]));
        if (isExact(extensions[int(i)]))
            QVERIFY2(meshes[i].vertices == meshes[0].vertices, qPrintable(extensions[int(i)]));
    }
}

void SurfaceASampleTest::groupsOfTheObjAreTheRegions()
{
    const QString out = path("groups.obj"), reportPath = path("groups.json");
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(samplePath("bevelled-box"), out, {"--report", reportPath}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    std::set<QByteArray> groups;
    int creases = 0, facesOutsideGroups = 0;
    QByteArray group;
    for (const QByteArray &line : bytesOf(out).split('\n')) {
        if (line.startsWith("g "))
            group = line.mid(2).trimmed();
        if (line.startsWith("f ")) {
            facesOutsideGroups += !group.startsWith("region_");
            groups.insert(group);
        }
        creases += line.startsWith("l ");
    }
    const Json report = Json::parse(bytesOf(reportPath).toStdString());
    QCOMPARE(facesOutsideGroups, 0);
    QCOMPARE(groups.size(), report.at("regions").size());
    QVERIFY2(groups.size() >= 6, "a box has six sides");
    QCOMPARE(creases, report.at("mesh").at("featureLines").get<int>());
    QVERIFY2(creases > 0, "a box has sharp edges");
}

void SurfaceASampleTest::pictureShowsSketchRegionsAndSurface()
{
    const QString out = path("shown.obj"), picturePath = path("shown.png");
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(samplePath("car"), out, {"--picture", picturePath}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const Result<Image> picture = readPng(picturePath.toStdString());
    QVERIFY(picture.ok());
    const Coverage sketch = coverageOf(*picture, 0), regions = coverageOf(*picture, 1),
                   clay = coverageOf(*picture, 2);
    QVERIFY2(sketch.dark > 0.003 && sketch.dark < 0.2, "strokes are thin dark lines");
    QVERIFY2(sketch.covered < 0.6 * regions.covered, "one looks through a sketch");
    QVERIFY2(clay.covered > 0.08 && clay.covered < 0.8, "the surface stands in the picture with air around");
    QVERIFY2(regions.colourful > 0.4 * clay.covered && regions.hues >= 3,
             "regions have colours of their own");
    QVERIFY2(clay.colourful < 0.01, "the surface is shown plain");
}

void SurfaceASampleTest::quietSaysNothing()
{
    const QString out = path("quiet.obj");
    const ProgramRun run = runSketchSurfacer(surfaceArguments(samplePath("bent-leaf"), out, {"--quiet"}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
    QCOMPARE(run.err, QString());
    QCOMPARE(run.out, QString());
    QVERIFY(!meshOf(out).isEmpty());
}

QTEST_GUILESS_MAIN(SurfaceASampleTest)
#include "surface_a_sample_test.moc"
