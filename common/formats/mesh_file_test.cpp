#include "formats/mesh_file.h"

#include "base/random.h"
#include "formats/atomic_file.h"

#include <QtTest>
#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

/// A bumpy sphere of quads split in two, closed, with awkward numbers.
TriangleMesh bumpySphere(int rings, int sectors)
{
    TriangleMesh mesh;
    Random random(5);
    mesh.vertices.emplace_back(0, 0, 1);
    for (int r = 1; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const double theta = M_PI * r / rings, phi = 2 * M_PI * s / sectors;
            const double radius = 1.0 + 0.05 * random.uniform();
            mesh.vertices.push_back(radius * Vec3(std::sin(theta) * std::cos(phi),
                                                  std::sin(theta) * std::sin(phi), std::cos(theta)));
        }
    mesh.vertices.emplace_back(0, 0, -1);
    const int last = mesh.vertexCount() - 1;
    const auto at = [&](int r, int s) { return 1 + (r - 1) * sectors + s % sectors; };
    for (int s = 0; s < sectors; ++s) {
        mesh.triangles.push_back({0, at(1, s), at(1, s + 1)});
        for (int r = 1; r + 1 < rings; ++r) {
            mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
        mesh.triangles.push_back({at(rings - 1, s), last, at(rings - 1, s + 1)});
    }
    return mesh;
}

MeshFileContent sampleContent()
{
    MeshFileContent content;
    content.mesh = bumpySphere(7, 9);
    for (const Triangle &t : content.mesh.triangles)
        content.triangleRegions.push_back(t[0] % 3 == 0 ? 7 : t[0] % 3);
    content.featureLines = {{0, 1, 2, 3}, {5, 6}};
    content.comment = "made by a test\nin two lines";
    return content;
}

/// Corner positions of all triangles, sorted, each triangle beginning with its smallest corner: equal for the
/// same surface with the same orientation, whatever the order of vertices and triangles.
std::vector<std::array<double, 9>> triangleSoup(const TriangleMesh &mesh, bool asFloat)
{
    std::vector<std::array<double, 9>> soup;
    for (const Triangle &t : mesh.triangles) {
        std::array<std::array<double, 3>, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t c = 0; c < 3; ++c) {
                const double x = mesh.vertices[std::size_t(t[k])][int(c)];
                corners[k][c] = asFloat ? double(float(x)) : x;
            }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::array<double, 9> flat;
        for (std::size_t i = 0; i < 9; ++i)
            flat[i] = corners[i / 3][i % 3];
        soup.push_back(flat);
    }
    std::sort(soup.begin(), soup.end());
    return soup;
}

const char *const tetrahedronObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

const char *const asciiPly = "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\n"
                             "property float y\nproperty float z\nproperty uchar red\nelement face 2\n"
                             "property list uchar int vertex_indices\nend_header\n"
                             "0 0 0 255\n1 0 0 0\n1 1 0 9\n0 1 0 9\n3 0 1 2\n4 0 1 2 3\n";

std::string bigEndianPly()
{
    std::string bytes =
        "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short id\nproperty float x\n"
        "property float y\nproperty double z\nelement face 1\nproperty list uint uchar vertex_index\n"
        "end_header\n";
    const auto append = [&](auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        std::reverse(raw, raw + sizeof value);
        bytes.append(raw, sizeof value);
    };
    for (int v = 0; v < 3; ++v) {
        append(std::int16_t(-v));
        append(float(v == 1));
        append(float(v == 2));
        append(0.25);
    }
    append(std::uint32_t(3));
    for (char corner : {0, 1, 2})
        bytes += corner;
    return bytes;
}

std::string asciiStl(int facets)
{
    std::string text = "solid thing\n";
    for (int i = 0; i < facets; ++i)
        text += "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1e0 " +
                std::to_string(i) + " 0\n      vertex 0 1 0\n    endloop\n  endfacet\n";
    return text + "endsolid thing\n";
}

} // namespace

class MeshFileTest : public QObject
{
    Q_OBJECT
private slots:
    void everyFormatComesBack_data();
    void everyFormatComesBack();
    void objGroupsRegionsAndFeatures();
    void plyKeepsRegionLabels();
    void equalCornersAreMerged();
    void polygonsAreFanned();
    void otherProgramsFlavours();
    void wrongInputNamesPlaceAndReason_data();
    void wrongInputNamesPlaceAndReason();
    void everyPrefixIsReadOrRefused_data();
    void everyPrefixIsReadOrRefused();
    void wrongContentIsNotWritten();
    void cancelWritesNothing();
    void writingIntoAMissingFolderIsSaid();
};

void MeshFileTest::everyFormatComesBack_data()
{
    QTest::addColumn<bool>("isFloat");
    QTest::addColumn<bool>("keepsIndices");
    QTest::newRow(".obj") << false << false;
    QTest::newRow(".ply") << false << true;
    QTest::newRow(".STL") << true << false;
    QTest::newRow(".off") << false << true;
    QTest::newRow(".glb") << true << false;
}

void MeshFileTest::everyFormatComesBack()
{
    QFETCH(bool, isFloat);
    QFETCH(bool, keepsIndices);
    QTemporaryDir folder;
    const fs::path path =
        fs::path(folder.path().toStdString()) / (std::string("Fläche") + QTest::currentDataTag());
    QVERIFY(isMeshExtension(path));
    const MeshFileContent content = sampleContent();
    const auto written = writeMesh(content, path, {});
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    const auto mesh = readMesh(path, {});
    QVERIFY2(mesh, mesh ? "" : mesh.error().message().c_str());
    // Merging corners must give the closed mesh back, not a soup.
    QCOMPARE(mesh->vertexCount(), content.mesh.vertexCount());
    QVERIFY(triangleSoup(*mesh, false) == triangleSoup(content.mesh, isFloat));
    if (keepsIndices) {
        QVERIFY(mesh->vertices == content.mesh.vertices);
        QVERIFY(mesh->triangles == content.mesh.triangles);
    }
    QVERIFY(signedVolume(*mesh) > 3.0);

    const auto bytes = meshBytes(content, path.extension().string(), {});
    QVERIFY(bytes.ok());
    QCOMPARE(*readWholeFile(path, 1 << 20, "Reading"), *bytes);
}

void MeshFileTest::objGroupsRegionsAndFeatures()
{
    const auto text = meshBytes(sampleContent(), ".obj", {});
    QVERIFY(text.ok());
    const std::size_t one = text->find("\ng region_1\n"), two = text->find("\ng region_2\n");
    const std::size_t seven = text->find("\ng region_7\n"), features = text->find("\ng features\n");
    QVERIFY(one < two && two < seven && seven < features && features != std::string::npos);
    QVERIFY(text->ends_with("g features\nl 1 2 3 4\nl 6 7\n"));
    QVERIFY(text->starts_with("# made by a test in two lines\nv 0 0 1\n"));
}

void MeshFileTest::plyKeepsRegionLabels()
{
    const MeshFileContent content = sampleContent();
    const auto bytes = meshBytes(content, ".ply", {});
    QVERIFY(bytes.ok());
    QVERIFY(bytes->find("property int region\n") != std::string::npos);
    const std::size_t body = bytes->find("end_header\n") + 11;
    for (std::size_t t = 0; t < content.mesh.triangles.size(); ++t) {
        std::int32_t region = -1;
        std::memcpy(&region, bytes->data() + body + content.mesh.vertices.size() * 24 + t * 17 + 13, 4);
        QCOMPARE(region, content.triangleRegions[t]);
    }
}

void MeshFileTest::equalCornersAreMerged()
{
    const auto mesh = parseMesh(asciiStl(3), "a.stl", {});
    QVERIFY2(mesh, mesh ? "" : mesh.error().message().c_str());
    QCOMPARE(mesh->vertexCount(), 5);
    QCOMPARE(mesh->triangleCount(), 3);
}

void MeshFileTest::polygonsAreFanned()
{
    const auto obj = parseMesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2//2 3/3 -1\n", "a.obj", {});
    QVERIFY(obj.ok());
    QVERIFY(obj->triangles == (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    const auto ply = parseMesh(asciiPly, "a.ply", {});
    QVERIFY2(ply, ply ? "" : ply.error().message().c_str());
    QVERIFY(ply->triangles == (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
    const auto repeated = parseMesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 2 3\n", "a.obj", {});
    QVERIFY(repeated.ok());
    QCOMPARE(repeated->triangleCount(), 1); // the half with a corner twice is left out
}

void MeshFileTest::otherProgramsFlavours()
{
    const auto big = parseMesh(bigEndianPly(), "a.ply", {});
    QVERIFY2(big, big ? "" : big.error().message().c_str());
    QVERIFY(big->vertices == (std::vector<Vec3>{{0, 0, 0.25}, {1, 0, 0.25}, {0, 1, 0.25}}));
    QVERIFY(big->triangles == (std::vector<Triangle>{{0, 1, 2}}));

    for (const char *text :
         {"OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
          "# c\r\nCOFF\r\n\r\n3 1 # n\r\n0 0 0 255 0 0 255\r\n1 0 0 1 1 1 1\r\n0 1 0 1 1 1 "
          "1\r\n3 0 1 2 0.5 0.5 0.5\r\n",
          "STCNOFF\n3 1 3\n0 0 0 9 9\n1 0 0 9 9\n0 1 0 9 9\n3 0 1 2"}) {
        // A comment before the header hides the word the kind is told by; the reader itself takes it.
        const std::string name = "a.off";
        const auto mesh = parseMesh(
            std::string_view(text).starts_with('#') ? std::string_view(text).substr(5) : text, name, {});
        QVERIFY2(mesh, mesh ? "" : mesh.error().message().c_str());
        QVERIFY(mesh->triangles == (std::vector<Triangle>{{0, 1, 2}}));
    }
    // Binary STL whose free header begins with "solid".
    auto stl = meshBytes(sampleContent(), ".stl", {});
    QVERIFY(stl.ok());
    stl->replace(0, 6, "solid ");
    const auto mesh = parseMesh(*stl, "a.stl", {});
    QVERIFY(mesh.ok());
    QCOMPARE(mesh->triangleCount(), sampleContent().mesh.triangleCount());
}

void MeshFileTest::wrongInputNamesPlaceAndReason_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("words");
    const auto row = [](const char *title, const std::string &bytes, const QString &name, ErrorCode code,
                        const QString &words) {
        QTest::newRow(title) << QByteArray(bytes.data(), qsizetype(bytes.size())) << name << int(code)
                             << words;
    };
    constexpr ErrorCode bad = ErrorCode::Malformed;
    const std::string obj = tetrahedronObj;
    row("empty", "", "a.obj", ErrorCode::TooLittleData, "empty");
    row("text", "hello world\n", "a.obj", ErrorCode::Unsupported, "no mesh");
    row("binary", std::string("\x7f\0\x01 ELF\n", 8), "a.obj", bad, "binary");
    row("no faces", "v 0 0 0\n", "a.obj", ErrorCode::TooLittleData, "no triangles");
    row("a sketch", "v 0 0 0\nv 1 0 0\nl 1 2\n", "a.obj", ErrorCode::Unsupported, "sketch");
    row("obj index", obj + "f 1 2 5\n", "a.obj", bad, "a.obj:9");
    row("obj negative index", obj + "f -1 -2 -5\n", "a.obj", bad, "a.obj:9");
    row("obj nan", obj + "v nan 0 0\n", "a.obj", bad, "a.obj:9");
    row("obj comma", obj + "v 0,5 0 0\n", "a.obj", bad, "comma");
    row("obj two corners", obj + "f 1 2\n", "a.obj", bad, "a.obj:9");
    row("ply count",
        "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty "
        "float y\nproperty float z\nend_header\nxxxx",
        "a.ply", bad, "room");
    row("ply negative", "ply\nformat ascii 1.0\nelement vertex -4\n", "a.ply", bad, "a.ply:3");
    row("ply no header end", "ply\nformat ascii 1.0\n", "a.ply", bad, "end_header");
    row("ply format", "ply\nformat utf8 1.0\n", "a.ply", ErrorCode::Unsupported, "utf8");
    row("ply no z",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
        "a.ply", bad, "no x, y and z");
    row("ply list length",
        std::string("ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list int int "
                    "vertex_indices\nend_header\n\xff\xff\xff\x7f",
                    109),
        "a.ply", bad, "list");
    row("stl cut",
        std::string("x", 1) + std::string(79, ' ') + std::string("\x05\0\0\0", 4) + std::string(60, '\0'),
        "a.stl", bad, "announces 5 triangles but has room for 1");
    row("stl short", "x", "a.stl", bad, "shorter");
    row("stl ascii cut", asciiStl(2).substr(0, 150), "a.stl", bad, "inside a facet");
    row("stl ascii word", "solid\nfacet normal 0 0 1\nvertices\n", "a.stl", bad, "a.stl:3");
    row("off counts", "OFF\n1000000 1 0\n0 0 0\n", "a.off", bad, "a.off:2");
    row("off negative", "OFF\n3 -1 0\n", "a.off", bad, "a.off:2");
    row("off cut", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "a.off", bad, "vertex 2");
    row("off corners", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", "a.off", bad, "a.off:6");
    row("off index", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off", bad, "a.off:6");
    row("gltf text", "{\"asset\":{}}", "a.gltf", ErrorCode::Unsupported, "glb");
}

void MeshFileTest::wrongInputNamesPlaceAndReason()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, name);
    QFETCH(int, code);
    QFETCH(QString, words);
    const auto mesh = parseMesh(bytes.toStdString(), name.toStdString(), {});
    QVERIFY(!mesh.ok());
    const QString message = QString::fromStdString(mesh.error().message());
    QVERIFY2(int(mesh.error().code) == code, qPrintable(message));
    QVERIFY2(message.contains(words), qPrintable(message));
    QVERIFY2(message.startsWith(name), qPrintable(message));
    QVERIFY(!mesh.error().remedy.empty());
}

void MeshFileTest::everyPrefixIsReadOrRefused_data()
{
    QTest::addColumn<bool>("isBinary");
    QTest::newRow(".obj") << false;
    QTest::newRow(".ply") << true;
    QTest::newRow(".stl") << true;
    QTest::newRow(".off") << false;
    QTest::newRow(".glb") << true;
}

void MeshFileTest::everyPrefixIsReadOrRefused()
{
    QFETCH(bool, isBinary);
    const auto bytes = meshBytes(sampleContent(), QTest::currentDataTag(), {});
    QVERIFY(bytes.ok());
    for (std::size_t length = 0; length < bytes->size(); ++length) {
        const auto mesh = parseMesh(std::string_view(*bytes).substr(0, length),
                                    std::string("a") + QTest::currentDataTag(), {});
        if (mesh) {
            QVERIFY2(!isBinary, "binary formats announce their size, so a cut must be noticed");
            for (const Triangle &t : mesh->triangles)
                for (int v : t)
                    QVERIFY(v >= 0 && v < mesh->vertexCount());
        } else {
            QVERIFY(!mesh.error().message().empty());
        }
    }
}

void MeshFileTest::wrongContentIsNotWritten()
{
    QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "a.obj";
    const auto codeOf = [&](auto change) {
        MeshFileContent content = sampleContent();
        change(content);
        const auto result = writeMesh(content, path, {});
        return result ? -1 : int(result.error().code);
    };
    const int invalid = int(ErrorCode::InvalidArgument);
    QCOMPARE(codeOf([](MeshFileContent &c) { c.mesh.triangles[3][1] = c.mesh.vertexCount(); }), invalid);
    QCOMPARE(codeOf([](MeshFileContent &c) { c.mesh.triangles[3][1] = -1; }), invalid);
    QCOMPARE(codeOf([](MeshFileContent &c) { c.mesh.vertices[2].y() = NAN; }), invalid);
    QCOMPARE(codeOf([](MeshFileContent &c) { c.triangleRegions.pop_back(); }), invalid);
    QCOMPARE(codeOf([](MeshFileContent &c) { c.triangleRegions[0] = -2; }), invalid);
    QCOMPARE(codeOf([](MeshFileContent &c) { c.featureLines.push_back({1, 1000}); }), invalid);
    QCOMPARE(codeOf([](MeshFileContent &c) { c = {}; }), int(ErrorCode::TooLittleData));
    QCOMPARE(writeMesh(sampleContent(), folder.path().toStdString() + "/a.xyz", {}).error().code,
             ErrorCode::InvalidArgument);
    QVERIFY(fs::is_empty(folder.path().toStdString()));
}

void MeshFileTest::cancelWritesNothing()
{
    QTemporaryDir folder;
    const std::atomic<bool> cancelled = true;
    for (const char *extension : {".obj", ".ply", ".stl", ".off", ".glb"}) {
        const auto result = writeMesh(sampleContent(), folder.path().toStdString() + "/a" + extension,
                                      JobControl(&cancelled, {}));
        QVERIFY(!result.ok());
        QVERIFY(result.error().isCancelled());
    }
    QVERIFY(fs::is_empty(folder.path().toStdString()));
}

void MeshFileTest::writingIntoAMissingFolderIsSaid()
{
    QTemporaryDir folder;
    const auto result = writeMesh(sampleContent(), folder.path().toStdString() + "/none/a.obj", {});
    QVERIFY(!result.ok());
    QCOMPARE(result.error().code, ErrorCode::FileNotFound);
}

QTEST_APPLESS_MAIN(MeshFileTest)
#include "mesh_file_test.moc"
