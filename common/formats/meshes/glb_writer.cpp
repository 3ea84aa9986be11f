// Writing binary glTF 2.0 (Khronos, ISO/IEC 12113): header, JSON chunk, BIN chunk.
#include "formats/meshes/byte_reader.h"
#include "formats/meshes/mesh_formats.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

using Json = nlohmann::json;

constexpr int componentFloat = 5126;
constexpr int componentUInt16 = 5123;
constexpr int componentUInt32 = 5125;
constexpr int targetVertices = 34962;
constexpr int targetIndices = 34963;

/// Colours that stay apart for any number of regions: hues at golden-angle steps. Linear RGB as glTF asks.
std::array<double, 3> regionColour(int region)
{
    const double turns = region * 0.6180339887498949;
    const double hue = turns - std::floor(turns);
    std::array<double, 3> colour;
    for (int k = 0; k < 3; ++k) {
        // A triangle wave over the hue with its peak at red, green or blue; sRGB value 0.35 .. 0.9.
        const double distance = std::abs(hue - k / 3.0);
        const double around = std::min(distance, 1.0 - distance);
        const double level = std::clamp(2.0 - 6.0 * around, 0.0, 1.0);
        // Three decimals: enough for a colour, and the same text whatever the last bit of pow().
        colour[std::size_t(k)] = std::round(1000.0 * std::pow(0.35 + 0.55 * level, 2.2)) / 1000.0;
    }
    return colour;
}

/// Collects views and accessors while the binary chunk grows.
class GlbWriter
{
public:
    explicit GlbWriter(const MeshFileContent &content);

    /// One primitive of its own vertices, so that normals are not smoothed over the border of a region.
    void addRegion(int region, const std::vector<int> &triangles);
    std::string finish();

private:
    struct Part
    {
        TriangleMesh mesh;
        std::vector<int> used; // the content's vertex of each
    };
    Part partOf(const std::vector<int> &triangles);
    Json materialOf(int region, const Part &part) const;
    Json &primitivesFor(int region);
    int addVectors(const std::vector<Vec3> &vectors, bool withBounds);
    int addColours(const std::vector<int> &vertices);
    int addIndices(const std::vector<Triangle> &triangles);
    int addAccessor(std::size_t viewBegin, int target, Json accessor);

    const MeshFileContent &mContent;
    std::vector<int> mLocalFromGlobal; // all -1 between regions
    Json mRoot;
    std::string mBinary;
};

GlbWriter::GlbWriter(const MeshFileContent &content)
    : mContent(content), mLocalFromGlobal(content.mesh.vertices.size(), -1)
{
    mRoot["asset"] = {{"version", "2.0"}, {"generator", "Ductus"}};
    mRoot["extras"] = {{"comment", commentLine(content)}};
    mRoot["scene"] = 0;
    mRoot["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
    mRoot["nodes"] = Json::array({{{"mesh", 0}, {"name", "surface"}}});
    mRoot["meshes"] = Json::array({{{"name", "surface"}, {"primitives", Json::array()}}});
    if (!content.regionNames.empty()) { // each region adds its own
        mRoot["scenes"][0]["nodes"] = Json::array();
        mRoot["nodes"] = mRoot["meshes"] = Json::array();
    }
    if (!content.vertexColours.empty())
        mRoot["extensionsUsed"] = {"KHR_materials_unlit"};
    mRoot["materials"] = mRoot["accessors"] = mRoot["bufferViews"] = Json::array();
}

int GlbWriter::addAccessor(std::size_t viewBegin, int target, Json accessor)
{
    accessor["bufferView"] = mRoot["bufferViews"].size();
    mRoot["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", viewBegin},
                                    {"byteLength", mBinary.size() - viewBegin},
                                    {"target", target}});
    mRoot["accessors"].push_back(std::move(accessor));
    return int(mRoot["accessors"].size()) - 1;
}

int GlbWriter::addVectors(const std::vector<Vec3> &vectors, bool withBounds)
{
    const std::size_t begin = mBinary.size();
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
    for (const Vec3 &vector : vectors)
        for (std::size_t k = 0; k < 3; ++k) {
            const float value = float(vector[int(k)]);
            low[k] = std::min(low[k], value);
            high[k] = std::max(high[k], value);
            appendLittleEndian(mBinary, value);
        }
    Json accessor = {{"componentType", componentFloat}, {"count", vectors.size()}, {"type", "VEC3"}};
    if (withBounds) {
        accessor["min"] = low;
        accessor["max"] = high;
    }
    return addAccessor(begin, targetVertices, std::move(accessor));
}

/// 16 bits a number: 8 would show steps in dark linear colours.
int GlbWriter::addColours(const std::vector<int> &vertices)
{
    const std::size_t begin = mBinary.size();
    for (const int v : vertices)
        for (int k = 0; k < 4; ++k)
            appendLittleEndian(
                mBinary, std::uint16_t(std::lround(65535.f * mContent.vertexColours[std::size_t(v)][k])));
    return addAccessor(begin, targetVertices,
                       {{"componentType", componentUInt16},
                        {"count", vertices.size()},
                        {"type", "VEC4"},
                        {"normalized", true}});
}

int GlbWriter::addIndices(const std::vector<Triangle> &triangles)
{
    const std::size_t begin = mBinary.size();
    for (const Triangle &t : triangles)
        for (const int v : t)
            appendLittleEndian(mBinary, std::uint32_t(v));
    return addAccessor(
        begin, targetIndices,
        {{"componentType", componentUInt32}, {"count", 3 * triangles.size()}, {"type", "SCALAR"}});
}

/// The triangles with the vertices they use, in the order of first use.
GlbWriter::Part GlbWriter::partOf(const std::vector<int> &triangles)
{
    Part found;
    auto &[part, used] = found;
    for (const int t : triangles) {
        Triangle mapped;
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = mContent.mesh.triangles[std::size_t(t)][k];
            int &local = mLocalFromGlobal[std::size_t(v)];
            if (local < 0) {
                local = part.vertexCount();
                part.vertices.push_back(mContent.mesh.vertices[std::size_t(v)]);
                used.push_back(v);
            }
            mapped[k] = local;
        }
        part.triangles.push_back(mapped);
    }
    for (const int v : used)
        mLocalFromGlobal[std::size_t(v)] = -1;
    return found;
}

Json GlbWriter::materialOf(int region, const Part &part) const
{
    const std::string name = mContent.regionNames.empty() ? "region_" + std::to_string(region)
                                                          : mContent.regionNames[std::size_t(region)];
    if (mContent.vertexColours.empty()) {
        const auto colour = regionColour(region);
        return {{"name", name},
                {"doubleSided", true},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", {colour[0], colour[1], colour[2], 1.0}},
                  {"metallicFactor", 0.0},
                  {"roughnessFactor", 0.7}}}};
    }
    const bool isTranslucent = std::any_of(part.used.begin(), part.used.end(), [&](int v) {
        return mContent.vertexColours[std::size_t(v)].w() < 1.f;
    });
    return {{"name", name},
            {"doubleSided", true},
            {"alphaMode", isTranslucent ? "BLEND" : "OPAQUE"},
            {"extensions", {{"KHR_materials_unlit", Json::object()}}},
            // For programs that do not know unlit materials.
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {1.0, 1.0, 1.0, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}};
}

Json &GlbWriter::primitivesFor(int region)
{
    if (!mContent.regionNames.empty()) {
        const std::string &name = mContent.regionNames[std::size_t(region)];
        const std::size_t index = mRoot["meshes"].size();
        mRoot["meshes"].push_back({{"name", name}, {"primitives", Json::array()}});
        mRoot["nodes"].push_back({{"mesh", index}, {"name", name}});
        mRoot["scenes"][0]["nodes"].push_back(index);
    }
    return mRoot["meshes"].back()["primitives"];
}

void GlbWriter::addRegion(int region, const std::vector<int> &triangles)
{
    const Part part = partOf(triangles);
    std::vector<Vec3> normals = vertexNormals(part.mesh);
    for (Vec3 &normal : normals)
        if (normal.isZero())
            normal = Vec3::UnitY(); // glTF wants unit length, also where all triangles are degenerate

    mRoot["materials"].push_back(materialOf(region, part));
    Json attributes;
    attributes["POSITION"] = addVectors(part.mesh.vertices, true);
    attributes["NORMAL"] = addVectors(normals, false);
    if (!mContent.vertexColours.empty())
        attributes["COLOR_0"] = addColours(part.used);
    primitivesFor(region).push_back({{"attributes", attributes},
                                     {"indices", addIndices(part.mesh.triangles)},
                                     {"material", mRoot["materials"].size() - 1},
                                     {"mode", 4}});
}

std::string GlbWriter::finish()
{
    mRoot["buffers"] = Json::array({{{"byteLength", mBinary.size()}}});
    std::string json = mRoot.dump(-1, ' ', false, Json::error_handler_t::replace);
    json.append((4 - json.size() % 4) % 4, ' ');
    mBinary.append((4 - mBinary.size() % 4) % 4, '\0');
    std::string bytes;
    bytes.reserve(28 + json.size() + mBinary.size());
    const auto append = [&](std::uint32_t number) { appendLittleEndian(bytes, number); };
    append(0x46546C67); // "glTF"
    append(2);
    append(std::uint32_t(28 + json.size() + mBinary.size()));
    append(std::uint32_t(json.size()));
    append(0x4E4F534A); // "JSON"
    bytes += json;
    append(std::uint32_t(mBinary.size()));
    append(0x004E4942); // "BIN"
    bytes += mBinary;
    return bytes;
}

} // namespace

Result<std::string> writeGlbMesh(const MeshFileContent &content, const JobControl &control)
{
    // 24 bytes a vertex of each region it is in (at most one a corner) and 8 for its colour, 12 a triangle;
    // sizes are 32-bit.
    const std::uint64_t corners = 3 * std::uint64_t(content.mesh.triangleCount());
    const std::uint64_t mostVertices = regionsOf(content).size() == 1
                                           ? std::min<std::uint64_t>(corners, content.mesh.vertices.size())
                                           : corners;
    if (mostVertices * (content.vertexColours.empty() ? 24 : 32) + 4 * corners > 0xF0000000ull)
        return Error{ErrorCode::TooLarge, "Writing the mesh", "the mesh is larger than a GLB file can be",
                     "Write it as PLY", ""};
    const std::vector<int> regions = regionsOf(content);
    std::vector<std::vector<int>> trianglesOf(regions.size());
    for (int t = 0; t < content.mesh.triangleCount(); ++t) {
        const auto place = std::lower_bound(regions.begin(), regions.end(), regionOf(content, t));
        trianglesOf[std::size_t(place - regions.begin())].push_back(t);
    }
    GlbWriter writer(content);
    for (std::size_t r = 0; r < regions.size(); ++r) {
        if (control.isCancelled())
            return cancelledError("Writing the mesh");
        control.progress(double(r) / double(regions.size()), "Writing the mesh");
        writer.addRegion(regions[r], trianglesOf[r]);
    }
    return writer.finish();
}

} // namespace ductus
