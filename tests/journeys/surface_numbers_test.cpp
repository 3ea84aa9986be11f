// "What can I rely on, and can I print it?": the numbers beside a surface, for scripts: what the sketch
// leaves open, and what a printer would meet.
#include "journeys/sketch_journey.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <nlohmann/json.hpp>

using namespace ductus;
using Json = nlohmann::json;

class SurfaceNumbersTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void whatTheSketchLeavesOpenIsANumberAtEveryPoint();
    void thePrintIsMeasured();
    void infoSaysTheSameOfTheProject();
    void infoMeasuresMeshFilesInTheirUnit();
    void infoRefusesInWords();

private:
    QString path(const QString &name) const { return mFolder.filePath(name); }
    Json jsonOf(const QString &name) const
    {
        return Json::parse(bytesOf(path(name)).toStdString(), nullptr, false);
    }

    QTemporaryDir mFolder;
};

void SurfaceNumbersTest::initTestCase()
{
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(samplePath("bevelled-box"), path("box.ductus"),
                         {"--report", path("r.json"), "--ambiguity", path("a.json"), "--runs", "2"}));
    QVERIFY2(!run.crashed && run.exitCode == 0, run.told().constData());
}

void SurfaceNumbersTest::whatTheSketchLeavesOpenIsANumberAtEveryPoint()
{
    const Json report = jsonOf("a.json");
    QVERIFY(report.is_object());
    QCOMPARE(report.at("schema").get<std::string>(), std::string("ambiguity"));
    QCOMPARE(report.at("version").get<int>(), 1);
    const Json &points = report.at("points"), &values = report.at("ambiguity");
    QVERIFY(points.size() > 500);
    QCOMPARE(values.size(), points.size());
    // In the sketch's unit: around the sketch's box, and hardly larger.
    const Box3 box = strokesOf(samplePath("bevelled-box")).box();
    Box3 around;
    for (const Json &p : points) {
        QCOMPARE(p.size(), std::size_t(3));
        around.add({p[0].get<double>(), p[1].get<double>(), p[2].get<double>()});
    }
    QVERIFY((around.min - box.min).norm() < 0.1 * box.diagonal());
    QVERIFY((around.max - box.max).norm() < 0.1 * box.diagonal());
    std::vector<double> sorted;
    for (const Json &value : values) {
        sorted.push_back(value.get<double>());
        QVERIFY(sorted.back() >= 0.0 && sorted.back() <= 1.0);
    }
    // Flat faces drawn all around leave little open: half of all places next to nothing.
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
    QVERIFY2(sorted[sorted.size() / 2] < 0.2, qPrintable(QString::number(sorted[sorted.size() / 2])));
    for (const Json &reading : report.at("otherReadings")) {
        QVERIFY(reading.at("models").get<int>() >= 1);
        QVERIFY(reading.at("energy").get<double>() > 0.5);
    }
}

void SurfaceNumbersTest::thePrintIsMeasured()
{
    const Json print = jsonOf("r.json").at("print");
    QCOMPARE(print.at("watertight").get<bool>(), true);
    QCOMPARE(print.at("pieces").get<int>(), 1);
    const Vec3 size = [&] {
        const Box3 box = strokesOf(samplePath("bevelled-box")).box();
        return Vec3(1000.0 * (box.max - box.min));
    }();
    for (int axis = 0; axis < 3; ++axis) {
        const double told = print.at("sizeMillimetres")[std::size_t(axis)].get<double>();
        QVERIFY2(std::abs(told / size[axis] - 1.0) < 0.08,
                 qPrintable(QString("%1 %2").arg(told).arg(size[axis])));
    }
    // A solid box: through and through.
    const double wall = print.at("thinnestWall").at("millimetres").get<double>();
    QVERIFY2(wall > 0.3 * size.minCoeff() && wall < 1.1 * size.minCoeff(), qPrintable(QString::number(wall)));
    const bool crosses = print.at("selfCrossings").at("trianglePairs").get<int>() > 0;
    QCOMPARE(print.at("selfCrossings").at("place").is_null(), !crosses);
    const double volume = print.at("volumeCubicMillimetres").get<double>();
    QVERIFY(volume > 0.3 * size.prod() && volume < 1.1 * size.prod());
}

void SurfaceNumbersTest::infoSaysTheSameOfTheProject()
{
    const ProgramRun run = runSketchSurfacer({"info", path("box.ductus"), "--json"});
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const Json info = Json::parse(run.out.toStdString(), nullptr, false);
    QVERIFY2(info.is_object(), run.told().constData());
    const Json &document = info.at("documents").at(0);
    QCOMPARE(document.at("kind").get<std::string>(), std::string("sketch-surface"));
    QVERIFY(document.at("surface").at("print") == jsonOf("r.json").at("print"));
    const ProgramRun words = runSketchSurfacer({"info", path("box.ductus")});
    QVERIFY(words.out.contains("watertight") && words.out.contains("thinnest wall"));
    QVERIFY(words.err.isEmpty());
}

void SurfaceNumbersTest::infoMeasuresMeshFilesInTheirUnit()
{
    // A plate of 40 x 0.5 x 30.
    QVERIFY(writeBytes(path("plate.off"), "OFF\n8 12 0\n0 0 0\n40 0 0\n0 0.5 0\n40 0.5 0\n0 0 30\n40 0 30\n"
                                          "0 0.5 30\n40 0.5 30\n3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n"
                                          "3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n"));
    const ProgramRun run = runSketchSurfacer({"info", path("plate.off"), "--unit", "mm", "--json"});
    QVERIFY2(run.exitCode == 0, run.told().constData());
    const Json print = Json::parse(run.out.toStdString()).at("print");
    QCOMPARE(print.at("thinnestWall").at("millimetres").get<double>(), 0.5);
    QCOMPARE(print.at("volumeCubicMillimetres").get<double>(), 600.0);
}

void SurfaceNumbersTest::infoRefusesInWords()
{
    QVERIFY(writeBytes(path("broken.ductus"), "no zip"));
    const ProgramRun broken = runSketchSurfacer({"info", path("broken.ductus")});
    QCOMPARE(broken.exitCode, 1);
    QVERIFY2(broken.err.contains("broken.ductus") && broken.out.isEmpty(), broken.told().constData());
    QCOMPARE(runSketchSurfacer({"info"}).exitCode, 2);
    QCOMPARE(runSketchSurfacer({"info", path("box.ductus"), "--unit", "ell"}).exitCode, 2);
}

QTEST_GUILESS_MAIN(SurfaceNumbersTest)
#include "surface_numbers_test.moc"
