#include "formats/meshes/byte_reader.h"
#include "formats/meshes/mesh_formats.h"

#include <QtTest>
#include <nlohmann/json.hpp>

using namespace ductus;
using Json = nlohmann::json;

namespace {

std::string container(const std::string &json, const std::string &binary)
{
    std::string bytes = "glTF";
    const auto append = [&](std::size_t n) { appendLittleEndian(bytes, std::uint32_t(n)); };
    append(2);
    append(28 + json.size() + binary.size());
    append(json.size());
    append(0x4E4F534A);
    bytes += json;
    append(binary.size());
    append(0x004E4942);
    return bytes + binary;
}

/// One triangle (0,0,0) (1,0,0) (0,1,0) with 16-bit indices, in one node.
Json triangleScene()
{
    return Json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": 42}]})");
}

std::string triangleData()
{
    std::string binary;
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
        appendLittleEndian(binary, x);
    for (const std::uint16_t i : {0, 1, 2})
        appendLittleEndian(binary, i);
    return binary;
}

Result<TriangleMesh> read(const Json &scene)
{
    return readGlbMesh(container(scene.dump(), triangleData()), "a.glb", {});
}

} // namespace

class GlbMeshTest : public QObject
{
    Q_OBJECT
private slots:
    void plainTriangle();
    void nodesPlaceMeshes();
    void mirrorsKeepTheOutside();
    void stripsAndFans();
    void wrongScenesAreRefused_data();
    void wrongScenesAreRefused();
    void repeatedNodesCannotFillTheMemory();
    void writerMakesAValidContainer();
    void coloursComeBack();
    void coloursOfMaterialsAndVerticesAreMultiplied();
    void wrongColoursAreRefused_data();
    void wrongColoursAreRefused();
};

void GlbMeshTest::plainTriangle()
{
    const auto mesh = read(triangleScene());
    QVERIFY2(mesh, mesh ? "" : mesh.error().message().c_str());
    QVERIFY(mesh->vertices == (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    QVERIFY(mesh->triangles == (std::vector<Triangle>{{0, 1, 2}}));
}

void GlbMeshTest::nodesPlaceMeshes()
{
    Json scene = triangleScene();
    // Parent turns x to y (90 degrees about z) and moves; child scales first.
    scene["nodes"] = Json::parse(R"([{"children": [1], "translation": [10, 0, 0],
        "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}, {"mesh": 0, "scale": [2, 3, 4]}])");
    const auto mesh = read(scene);
    QVERIFY2(mesh, mesh ? "" : mesh.error().message().c_str());
    QVERIFY((mesh->vertices[0] - Vec3(10, 0, 0)).norm() < 1e-12);
    QVERIFY((mesh->vertices[1] - Vec3(10, 2, 0)).norm() < 1e-12);
    QVERIFY((mesh->vertices[2] - Vec3(7, 0, 0)).norm() < 1e-12);
    // The same as one column-major matrix.
    scene["nodes"] =
        Json::parse(R"([{"mesh": 0, "matrix": [0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 10, 0, 0, 1]}])");
    const auto other = read(scene);
    QVERIFY(other.ok());
    for (std::size_t v = 0; v < 3; ++v)
        QVERIFY((other->vertices[v] - mesh->vertices[v]).norm() < 1e-12);
}

void GlbMeshTest::mirrorsKeepTheOutside()
{
    Json scene = triangleScene();
    scene["nodes"][0]["scale"] = {-1, 1, 1};
    const auto mesh = read(scene);
    QVERIFY(mesh.ok());
    QVERIFY(mesh->faceNormal(0).z() > 0.99);
}

void GlbMeshTest::stripsAndFans()
{
    Json scene = triangleScene();
    std::string binary;
    for (const auto &[x, y] : std::vector<std::pair<float, float>>{{0, 0}, {1, 0}, {0, 1}, {1, 1}})
        for (const float value : {x, y, 0.f})
            appendLittleEndian(binary, value);
    scene["bufferViews"] = {{{"buffer", 0}, {"byteLength", 48}}};
    scene["buffers"] = {{{"byteLength", 48}}};
    scene["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}}};
    scene["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}, {"mode", 5}};
    const auto strip = readGlbMesh(container(scene.dump(), binary), "a.glb", {});
    QVERIFY2(strip, strip ? "" : strip.error().message().c_str());
    QCOMPARE(strip->triangleCount(), 2);
    QVERIFY(strip->faceNormal(0).z() > 0.99 && strip->faceNormal(1).z() > 0.99);
    QVERIFY(std::abs(surfaceArea(*strip) - 1.0) < 1e-12);
    scene["meshes"][0]["primitives"][0]["mode"] = 6;
    const auto fan = readGlbMesh(container(scene.dump(), binary), "a.glb", {});
    QVERIFY(fan.ok());
    QVERIFY(fan->triangles == (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

void GlbMeshTest::wrongScenesAreRefused_data()
{
    QTest::addColumn<QByteArray>("pointer");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("words");
    const auto row = [](const char *title, const char *pointer, const char *value, const char *words) {
        QTest::newRow(title) << QByteArray(pointer) << QByteArray(value) << QByteArray(words);
    };
    row("accessor beyond the data", "/accessors/0/count", "4", "accessors[0]");
    row("absurd count", "/accessors/0/count", "1000000000000", "accessors[0]");
    row("negative count", "/accessors/0/count", "-1", "accessors[0]");
    row("count is text", "/accessors/0/count", "\"3\"", "accessors[0]");
    row("offset overflows", "/accessors/0/byteOffset", "18446744073709551615", "accessors[0]");
    row("view beyond the data", "/bufferViews/0/byteLength", "43", "bufferViews[0]");
    row("view offset", "/bufferViews/0/byteOffset", "9223372036854775807", "bufferViews[0]");
    row("overlapping items", "/bufferViews/0/byteStride", "4", "accessors[0]");
    row("index out of range", "/accessors/0/count", "2", "does not have");
    row("other file", "/buffers/0/uri", "\"a.bin\"", "another file");
    row("sparse", "/accessors/0/sparse", "{}", "sparsely");
    row("draco", "/extensionsRequired", "[\"KHR_draco_mesh_compression\"]", "compressed");
    row("no such mesh", "/nodes/0/mesh", "7", "meshes[7]");
    row("no such node", "/scenes/0/nodes", "[3]", "nodes[3]");
    row("own ancestor", "/nodes/0/children", "[0]", "ancestor");
    row("matrix of text", "/nodes/0/matrix", "[\"a\"]", "nodes[0]");
    row("no rotation", "/nodes/0/rotation", "[0,0,0,0]", "quaternion");
    row("huge placement", "/nodes/0/scale", "[1e300,1,1]", "too large");
    row("nodes are no objects", "/nodes", "[1]", "nodes[0]");
    row("nodes are no list", "/nodes", "{}", "nodes[0]");
    row("no nodes", "/scenes/0/nodes", "[]", "no triangles");
    row("lines only", "/meshes/0/primitives/0/mode", "1", "no triangles");
}

void GlbMeshTest::wrongScenesAreRefused()
{
    QFETCH(QByteArray, pointer);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, words);
    Json scene = triangleScene();
    scene[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
    const auto mesh = read(scene);
    QVERIFY(!mesh.ok());
    const QString message = QString::fromStdString(mesh.error().message());
    QVERIFY2(message.contains(QString::fromUtf8(words)), qPrintable(message));
    QVERIFY2(message.startsWith("a.glb"), qPrintable(message));
}

void GlbMeshTest::repeatedNodesCannotFillTheMemory()
{
    // 3000 nodes place one mesh of 10,000 vertices each: 30 million, more than is taken.
    Json scene = triangleScene();
    scene["accessors"][0]["count"] = 10000;
    scene["bufferViews"][0]["byteLength"] = 120000;
    scene["meshes"][0]["primitives"][0].erase("indices");
    Json roots = Json::array();
    scene["nodes"] = Json::array();
    for (int n = 0; n < 3000; ++n) {
        scene["nodes"].push_back({{"mesh", 0}});
        roots.push_back(n);
    }
    scene["scenes"][0]["nodes"] = roots;
    const auto mesh = readGlbMesh(container(scene.dump(), std::string(120000, '\0')), "a.glb", {});
    QVERIFY(!mesh.ok());
    QCOMPARE(mesh.error().code, ErrorCode::TooLarge);
}

void GlbMeshTest::writerMakesAValidContainer()
{
    MeshFileContent content;
    content.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    content.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    content.triangleRegions = {4, 4, 2, 2};
    const auto bytes = writeGlbMesh(content, {});
    QVERIFY(bytes.ok());
    ByteReader reader(*bytes);
    std::uint32_t magic, version, length, jsonSize, jsonType;
    QVERIFY(reader.read(magic) && reader.read(version) && reader.read(length) && reader.read(jsonSize) &&
            reader.read(jsonType));
    QCOMPARE(length, std::uint32_t(bytes->size()));
    QCOMPARE(jsonSize % 4, 0u);
    const Json scene = Json::parse(bytes->substr(20, jsonSize));
    const Json &primitives = scene["meshes"][0]["primitives"];
    QCOMPARE(primitives.size(), std::size_t(2));
    QVERIFY(scene["materials"][0]["pbrMetallicRoughness"] != scene["materials"][1]["pbrMetallicRoughness"]);
    QCOMPARE(scene["materials"][0]["name"].get<std::string>(), std::string("region_2"));
    const std::size_t data = 20 + jsonSize + 8;
    for (const Json &primitive : primitives)
        for (const char *attribute : {"POSITION", "NORMAL"}) {
            const Json &accessor = scene["accessors"][primitive["attributes"][attribute].get<std::size_t>()];
            const Json &view = scene["bufferViews"][accessor["bufferView"].get<std::size_t>()];
            QCOMPARE(view["byteOffset"].get<std::size_t>() % 4, std::size_t(0));
            QCOMPARE(view["byteLength"].get<std::size_t>(), accessor["count"].get<std::size_t>() * 12);
            ByteReader values(std::string_view(*bytes).substr(data + view["byteOffset"].get<std::size_t>()));
            for (std::size_t v = 0; v < accessor["count"].get<std::size_t>(); ++v) {
                float x[3];
                QVERIFY(values.read(x[0]) && values.read(x[1]) && values.read(x[2]));
                if (std::string(attribute) == "NORMAL")
                    QVERIFY(std::abs(Vec3(x[0], x[1], x[2]).norm() - 1.0) < 1e-6);
                else
                    for (std::size_t k = 0; k < 3; ++k)
                        QVERIFY(x[k] >= accessor["min"][k].get<float>() &&
                                x[k] <= accessor["max"][k].get<float>());
            }
        }
}

void GlbMeshTest::coloursComeBack()
{
    MeshFileContent content;
    // Two triangles that share an edge in space but not in colour.
    content.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    content.mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
    content.triangleRegions = {0, 1};
    content.regionNames = {"Stämme", "sky \xff"}; // the second is no UTF-8
    content.vertexColours = {{1, 0, 0, 1},          {0, 1, 0, 1},          {0, 0, 1, 1},
                             {.001f, .5f, .25f, 1}, {.5f, .5f, .5f, .25f}, {1, 1, 1, 0}};
    const auto bytes = meshBytes(content, ".glb", {});
    QVERIFY2(bytes, bytes ? "" : bytes.error().message().c_str());
    const auto read = readColouredGlbMesh(*bytes, "a.glb", {});
    QVERIFY2(read, read ? "" : read.error().message().c_str());
    QCOMPARE(read->mesh.vertexCount(), 6);
    QCOMPARE(read->vertexColours.size(), std::size_t(6));
    for (int t = 0; t < 2; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto written = std::size_t(content.mesh.triangles[std::size_t(t)][k]);
            const auto found = std::size_t(read->mesh.triangles[std::size_t(t)][k]);
            QVERIFY(read->mesh.vertices[found] == content.mesh.vertices[written]);
            const float off =
                (read->vertexColours[found] - content.vertexColours[written]).cwiseAbs().maxCoeff();
            QVERIFY2(off < 1.f / 65535, qPrintable(QString::number(off)));
        }
    // Without colours equal places are one vertex again.
    QCOMPARE(readGlbMesh(*bytes, "a.glb", {})->vertexCount(), 4);

    ByteReader header(std::string_view(*bytes).substr(12));
    std::uint32_t jsonSize = 0;
    QVERIFY(header.read(jsonSize));
    const Json scene = Json::parse(bytes->substr(20, jsonSize));
    QCOMPARE(scene["nodes"].size(), std::size_t(2));
    QCOMPARE(scene["nodes"][0]["name"].get<std::string>(), std::string("Stämme"));
    QVERIFY(scene["materials"][0]["extensions"].contains("KHR_materials_unlit"));
    QCOMPARE(scene["materials"][0]["alphaMode"].get<std::string>(), std::string("OPAQUE"));
    QCOMPARE(scene["materials"][1]["alphaMode"].get<std::string>(), std::string("BLEND"));
    for (const Json &view : scene["bufferViews"])
        QCOMPARE(view["byteOffset"].get<std::size_t>() % 4, std::size_t(0));

    content.vertexColours[3].x() = std::numeric_limits<float>::quiet_NaN();
    QVERIFY(!meshBytes(content, ".glb", {}).ok());
    content.vertexColours.pop_back();
    QVERIFY(!meshBytes(content, ".glb", {}).ok());
}

void GlbMeshTest::coloursOfMaterialsAndVerticesAreMultiplied()
{
    Json scene = triangleScene();
    QVERIFY(readColouredGlbMesh(container(scene.dump(), triangleData()), "a.glb", {})->vertexColours.empty());
    scene["materials"] = Json::parse(R"([{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 0.25, 1]}}])");
    scene["meshes"][0]["primitives"][0]["material"] = 0;
    auto read = readColouredGlbMesh(container(scene.dump(), triangleData()), "a.glb", {});
    QVERIFY2(read, read ? "" : read.error().message().c_str());
    QVERIFY(read->vertexColours[1] == Eigen::Vector4f(.5f, 1, .25f, 1));
    // Three bytes a vertex, padded to four, as other programs write them.
    std::string binary = triangleData() + std::string(2, '\0');
    for (int v = 0; v < 3; ++v)
        binary += {char(255), char(51), char(0), char(0)};
    scene["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", 44}, {"byteLength", 12}, {"byteStride", 4}});
    scene["buffers"][0]["byteLength"] = binary.size();
    scene["accessors"].push_back(
        {{"bufferView", 2}, {"componentType", 5121}, {"count", 3}, {"type", "VEC3"}, {"normalized", true}});
    scene["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 2;
    read = readColouredGlbMesh(container(scene.dump(), binary), "a.glb", {});
    QVERIFY2(read, read ? "" : read.error().message().c_str());
    QVERIFY((read->vertexColours[2] - Eigen::Vector4f(.5f, .2f, 0, 1)).norm() < 1e-6f);
}

void GlbMeshTest::wrongColoursAreRefused_data()
{
    QTest::addColumn<QByteArray>("pointer");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("words");
    const auto row = [](const char *title, const char *pointer, const char *value, const char *words) {
        QTest::newRow(title) << QByteArray(pointer) << QByteArray(value) << QByteArray(words);
    };
    row("no such accessor", "/meshes/0/primitives/0/attributes/COLOR_0", "9", "accessors[9]");
    row("one number each", "/meshes/0/primitives/0/attributes/COLOR_0", "1", "accessors[1]");
    row("index is text", "/meshes/0/primitives/0/attributes/COLOR_0", "\"0\"", "colours");
    row("too few", "/accessors/2/count", "2", "as many colours");
    row("no such material", "/meshes/0/primitives/0/material", "4", "materials[4]");
    row("three numbers", "/materials/0/pbrMetallicRoughness/baseColorFactor", "[1,1,1]", "base colour");
}

void GlbMeshTest::wrongColoursAreRefused()
{
    QFETCH(QByteArray, pointer);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, words);
    Json scene = triangleScene();
    scene["accessors"].push_back(
        {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    scene["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 2;
    scene["materials"] = Json::parse(R"([{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1]}}])");
    scene["meshes"][0]["primitives"][0]["material"] = 0;
    QVERIFY(readColouredGlbMesh(container(scene.dump(), triangleData()), "a.glb", {}).ok());
    scene[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
    const auto mesh = readColouredGlbMesh(container(scene.dump(), triangleData()), "a.glb", {});
    QVERIFY(!mesh.ok());
    const QString message = QString::fromStdString(mesh.error().message());
    QVERIFY2(message.contains(QString::fromUtf8(words)), qPrintable(message));
}

QTEST_APPLESS_MAIN(GlbMeshTest)
#include "glb_mesh_test.moc"
