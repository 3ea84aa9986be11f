// Sketches of other programs, read as they are. Counts: the SOURCES.md beside the files.
#include "formats/mesh_file.h"
#include "formats/sketch_file.h"

#include <QtTest>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

const fs::path sketches = fs::path(DUCTUS_SHARED_DATA) / "sketches";

using Key = std::array<double, 3>;
using Edge = std::pair<Key, Key>;

Key keyOf(const Vec3 &p)
{
    return {p.x(), p.y(), p.z()};
}

Edge edgeOf(const Key &a, const Key &b)
{
    return a < b ? Edge{a, b} : Edge{b, a};
}

/// Segments of an OBJ file by position, read in the plainest way.
std::multiset<Edge> segmentsOf(const fs::path &path, std::size_t &vertexCount)
{
    std::ifstream file(path);
    std::vector<Key> vertices;
    std::multiset<Edge> edges;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        Key p;
        std::size_t a, b;
        if (keyword == "v" && words >> p[0] >> p[1] >> p[2])
            vertices.push_back(p);
        else if (keyword == "l" && words >> a >> b)
            edges.insert(edgeOf(vertices[a - 1], vertices[b - 1]));
    }
    vertexCount = vertices.size();
    return edges;
}

} // namespace

class RealSketchesTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cassieCounts_data();
    void cassieCounts();
    void allCassieFilesAreRead();
    void linesAreChained_data();
    void linesAreChained();
    void networkCounts_data();
    void networkCounts();
    void pointCloudsAreKnownAsSuch_data();
    void pointCloudsAreKnownAsSuch();
    void meshesAreReadAndAreNoSketches_data();
    void meshesAreReadAndAreNoSketches();
};

void RealSketchesTest::initTestCase()
{
    if (!fs::is_directory(sketches))
        QSKIP("the folder with other people's sketches is not here");
}

void RealSketchesTest::cassieCounts_data()
{
    QTest::addColumn<int>("strokes");
    QTest::addColumn<int>("points");
    QTest::newRow("chair") << 199 << 1237;
    QTest::newRow("computer-mouse") << 34 << 257;
    QTest::newRow("guitar") << 148 << 770;
    QTest::newRow("hat") << 69 << 640;
    QTest::newRow("shield") << 82 << 683;
    QTest::newRow("vintage_car") << 163 << 2019;
}

void RealSketchesTest::cassieCounts()
{
    QFETCH(int, strokes);
    QFETCH(int, points);
    const auto file =
        readSketch(sketches / "cassie/curves" / (std::string(QTest::currentDataTag()) + ".curves"), {}, {});
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QCOMPARE(file->kind, SketchFileKind::Curves);
    QCOMPARE(int(file->strokes.strokes.size()), strokes);
    QCOMPARE(file->strokes.pointCount(), points);
}

void RealSketchesTest::allCassieFilesAreRead()
{
    int read = 0;
    for (const auto &entry : fs::directory_iterator(sketches / "cassie/curves")) {
        const auto file = readSketch(entry.path(), {}, {});
        QVERIFY2(file, file ? "" : file.error().message().c_str());
        QVERIFY(file->strokes.strokes.size() >= 16);
        QVERIFY(file->strokes.box().diagonal() > 0.3 && file->strokes.box().diagonal() < 6.0); // metres
        ++read;
    }
    QCOMPARE(read, 18);
}

void RealSketchesTest::linesAreChained_data()
{
    QTest::addColumn<int>("vertices");
    QTest::addColumn<int>("segments");
    QTest::addColumn<int>("parts");
    QTest::addColumn<int>("junctions");
    QTest::newRow("box") << 2906 << 2910 << 4 << 5;
    QTest::newRow("bulbasaur") << 5280 << 5124 << 156 << 4;
    QTest::newRow("car") << 3248 << 3245 << 16 << 25;
    QTest::newRow("guitar") << 2238 << 2153 << 85 << 0;
    QTest::newRow("iron") << 3111 << 3112 << 7 << 2;
    QTest::newRow("torus") << 2514 << 2516 << 6 << 2;
}

void RealSketchesTest::linesAreChained()
{
    QFETCH(int, vertices);
    QFETCH(int, segments);
    QFETCH(int, parts);
    QFETCH(int, junctions);
    const fs::path path = sketches / "lines" / (std::string(QTest::currentDataTag()) + ".obj");
    std::size_t vertexCount = 0;
    std::multiset<Edge> left = segmentsOf(path, vertexCount);
    QCOMPARE(int(vertexCount), vertices);
    QCOMPARE(int(left.size()), segments);
    std::map<Key, int> degree;
    for (const Edge &edge : left) {
        ++degree[edge.first];
        ++degree[edge.second];
    }
    const auto file = readSketch(path, {}, {});
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QCOMPARE(file->kind, SketchFileKind::ObjLines);

    // Strokes are exactly the segments; they end only at free ends and junctions; where they run on through a
    // junction they turn by less than 30 degrees.
    for (const Stroke &stroke : file->strokes.strokes) {
        const auto &p = stroke.points;
        for (std::size_t i = 1; i < p.size(); ++i) {
            const auto found = left.find(edgeOf(keyOf(p[i - 1]), keyOf(p[i])));
            QVERIFY(found != left.end());
            left.erase(found);
        }
        const bool closed = keyOf(p.front()) == keyOf(p.back());
        if (!closed)
            for (const Vec3 &end : {p.front(), p.back()})
                QVERIFY(degree[keyOf(end)] != 2);
        for (std::size_t i = 1; i + 1 < p.size(); ++i) {
            if (degree[keyOf(p[i])] == 2)
                continue;
            const double cosine = (p[i] - p[i - 1]).normalized().dot((p[i + 1] - p[i]).normalized());
            QVERIFY(cosine > std::cos(30.0 * M_PI / 180.0));
        }
    }
    QVERIFY(left.empty());
    const auto junctionCount =
        std::count_if(degree.begin(), degree.end(), [](const auto &d) { return d.second > 2; });
    QCOMPARE(int(junctionCount), junctions);
    if (junctions == 0)
        QCOMPARE(int(file->strokes.strokes.size()), parts);
    else
        QVERIFY(int(file->strokes.strokes.size()) >= parts);
    qInfo("%d strokes in %d parts", int(file->strokes.strokes.size()), parts);
}

void RealSketchesTest::networkCounts_data()
{
    QTest::addColumn<int>("curves");
    QTest::addColumn<int>("points");
    QTest::newRow("hill_3") << 3 << 217;
    QTest::newRow("shell_3") << 3 << 251;
    QTest::newRow("shell_100") << 60 << 3670;
    QTest::newRow("kagome_114_regular") << 114 << 4597;
    QTest::newRow("roof_75") << 75 << 4793;
}

void RealSketchesTest::networkCounts()
{
    QFETCH(int, curves);
    QFETCH(int, points);
    const auto file =
        readSketch(sketches / "networks/curves" / (std::string(QTest::currentDataTag()) + ".txt"), {}, {});
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QCOMPARE(file->kind, SketchFileKind::CurveText);
    QCOMPARE(int(file->strokes.strokes.size()), curves);
    QCOMPARE(file->strokes.pointCount(), points);
}

void RealSketchesTest::pointCloudsAreKnownAsSuch_data()
{
    QTest::addColumn<int>("points");
    QTest::newRow("planck/input_n500.xyz") << 500;
    QTest::newRow("hand/input_n500.xyz") << 500;
    QTest::newRow("torus/input_wires.xyz") << 991;
    QTest::newRow("trebol/input.xyz") << 498;
}

void RealSketchesTest::pointCloudsAreKnownAsSuch()
{
    QFETCH(int, points);
    const auto file = readSketch(sketches / "points" / QTest::currentDataTag(), {}, {});
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QVERIFY(file->isPointCloud);
    QCOMPARE(file->strokes.pointCount(), points);
    QCOMPARE(int(file->strokes.strokes.size()), points);
}

void RealSketchesTest::meshesAreReadAndAreNoSketches_data()
{
    QTest::addColumn<int>("vertices");
    QTest::addColumn<int>("triangles");
    QTest::newRow("points/torus/gt.obj") << 4096 << 8192;
    QTest::newRow("points/hand/gt.obj") << 16962 << 33920;
    QTest::newRow("points/planck/gt.obj") << 50112 << 100000;
    QTest::newRow("networks/meshes/hill.obj") << 920 << 1772;
    QTest::newRow("networks/meshes/kagome.obj") << 392 << 692;
    QTest::newRow("networks/meshes/roof.obj") << 809 << 1528;
    QTest::newRow("networks/meshes/shell.obj") << 791 << 1444;
}

void RealSketchesTest::meshesAreReadAndAreNoSketches()
{
    QFETCH(int, vertices);
    QFETCH(int, triangles);
    const fs::path path = sketches / QTest::currentDataTag();
    const auto mesh = readMesh(path, {});
    QVERIFY2(mesh, mesh ? "" : mesh.error().message().c_str());
    QCOMPARE(mesh->vertexCount(), vertices);
    QCOMPARE(mesh->triangleCount(), triangles);
    const auto sketch = readSketch(path, {}, {});
    QVERIFY(!sketch.ok());
    QCOMPARE(sketch.error().code, ErrorCode::Unsupported);
    QVERIFY(sketch.error().remedy.find("--proxy") != std::string::npos);
}

QTEST_APPLESS_MAIN(RealSketchesTest)
#include "real_sketches_test.moc"
