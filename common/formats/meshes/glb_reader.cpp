// Reading binary glTF 2.0 (Khronos, ISO/IEC 12113): triangles of the scene, placed by their nodes.
#include "formats/meshes/glb_document.h"
#include "formats/meshes/mesh_builder.h"
#include "formats/meshes/mesh_formats.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

using Json = nlohmann::json;

enum PrimitiveMode { Triangles = 4, TriangleStrip = 5, TriangleFan = 6 };

class GlbReader
{
public:
    GlbReader(const GlbDocument &document, bool withColours, const JobControl &control)
        : mDocument(document), mWithColours(withColours), mControl(control)
    {
    }

    /// The builder then has all triangles.
    Result<void> read();
    MeshBuilder &builder() { return mBuilder; }

private:
    struct Placed
    {
        std::int64_t node;
        Eigen::Affine3d sceneFromParent;
    };

    std::optional<Error> refuseCompression() const;
    Result<std::vector<std::int64_t>> rootNodes() const;
    Result<std::vector<std::int64_t>> indexList(const Json &object, const char *key,
                                                const std::string &where) const;
    Result<Eigen::Affine3d> parentFromNode(const Json &node, const std::string &where) const;
    std::optional<Error> addMesh(std::int64_t index, const Eigen::Affine3d &sceneFromMesh);
    std::optional<Error> addPrimitive(const Json &primitive, const Eigen::Affine3d &sceneFromMesh,
                                      const std::string &where);
    std::optional<Error> addTriangles(const std::vector<std::int64_t> &corners, std::int64_t mode, bool flip,
                                      const std::string &where);
    Result<std::vector<Eigen::Vector4f>> coloursOf(const Json &primitive, const Json &attributes,
                                                   std::size_t count, const std::string &where) const;

    const GlbDocument &mDocument;
    bool mWithColours;
    const JobControl &mControl;
    MeshBuilder mBuilder;
};

std::optional<Error> GlbReader::refuseCompression() const
{
    const auto required = mDocument.root.find("extensionsRequired");
    if (required == mDocument.root.end() || !required->is_array())
        return std::nullopt;
    for (const Json &extension : *required)
        for (const char *compression : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
            if (extension == compression)
                return mDocument.error("", std::string("the mesh is compressed (") + compression + ")",
                                       ErrorCode::Unsupported);
    return std::nullopt;
}

Result<std::vector<std::int64_t>> GlbReader::indexList(const Json &object, const char *key,
                                                       const std::string &where) const
{
    std::vector<std::int64_t> indices;
    const auto list = object.find(key);
    if (list == object.end())
        return indices;
    if (!list->is_array())
        return mDocument.error(where, std::string(key) + " is no list");
    for (const Json &index : *list) {
        if (!index.is_number_unsigned() || index.get<std::uint64_t>() > 0x7fffffff)
            return mDocument.error(where, std::string(key) + " has an entry that is no index");
        indices.push_back(index.get<std::int64_t>());
    }
    return indices;
}

/// Roots of the scene shown, or of the first one, or of a file without scenes all nodes that are nobody's
/// child.
Result<std::vector<std::int64_t>> GlbReader::rootNodes() const
{
    if (mDocument.root.contains("scenes")) {
        const auto scene = glbCount(mDocument.root, "scene", 0);
        if (!scene)
            return mDocument.error("scene", "it is no index");
        const Result<const Json *> item = mDocument.item("scenes", *scene);
        if (!item)
            return item.error();
        return indexList(**item, "nodes", "scenes[" + std::to_string(*scene) + "]");
    }
    std::vector<std::int64_t> roots;
    const auto nodes = mDocument.root.find("nodes");
    if (nodes == mDocument.root.end() || !nodes->is_array())
        return roots;
    std::vector<char> isChild(nodes->size(), 0);
    for (std::size_t n = 0; n < nodes->size(); ++n) {
        if (!(*nodes)[n].is_object())
            continue;
        const auto children = indexList((*nodes)[n], "children", "nodes[" + std::to_string(n) + "]");
        if (!children)
            return children.error();
        for (const std::int64_t child : *children)
            if (std::uint64_t(child) < isChild.size())
                isChild[std::size_t(child)] = 1;
    }
    for (std::size_t n = 0; n < isChild.size(); ++n)
        if (!isChild[n])
            roots.push_back(std::int64_t(n));
    return roots;
}

Result<Eigen::Affine3d> GlbReader::parentFromNode(const Json &node, const std::string &where) const
{
    const auto matrix = glbNumbers(node, "matrix", 16);
    const auto translation = glbNumbers(node, "translation", 3);
    const auto rotation = glbNumbers(node, "rotation", 4);
    const auto scale = glbNumbers(node, "scale", 3);
    if (!matrix || !translation || !rotation || !scale)
        return mDocument.error(where, "its placement is not made of the right count of finite numbers");
    Eigen::Affine3d parentFromNode = Eigen::Affine3d::Identity();
    if (!matrix->empty()) {
        parentFromNode.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix->data()); // column-major in both
        if (!parentFromNode.matrix().row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1)))
            return mDocument.error(where, "its matrix is not affine");
        return parentFromNode;
    }
    if (!translation->empty())
        parentFromNode.translate(Eigen::Vector3d((*translation)[0], (*translation)[1], (*translation)[2]));
    if (!rotation->empty()) {
        Eigen::Quaterniond q((*rotation)[3], (*rotation)[0], (*rotation)[1], (*rotation)[2]);
        if (!(q.norm() > 1e-6) || !(q.norm() < 1e6))
            return mDocument.error(where, "its rotation is no unit quaternion");
        parentFromNode.rotate(q.normalized());
    }
    if (!scale->empty())
        parentFromNode.scale(Eigen::Vector3d((*scale)[0], (*scale)[1], (*scale)[2]));
    return parentFromNode;
}

std::optional<Error> GlbReader::addTriangles(const std::vector<std::int64_t> &corners, std::int64_t mode,
                                             bool flip, const std::string &where)
{
    const std::size_t step = mode == Triangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
        std::int64_t triangle[3] = {corners[mode == TriangleFan ? 0 : i], corners[i + 1], corners[i + 2]};
        // Every second triangle of a strip runs the other way round; so does everything under a mirror.
        const bool odd = mode == TriangleStrip && i % 2 == 1;
        if (odd != flip)
            std::swap(triangle[1], triangle[2]);
        if (const auto fault = mBuilder.addPolygon(triangle))
            return Error{fault->code, readingTheMesh, fault->problem, fault->remedy,
                         mDocument.name + ": " + where};
    }
    return std::nullopt;
}

/// One a vertex; white where neither vertices nor material have a colour.
Result<std::vector<Eigen::Vector4f>> GlbReader::coloursOf(const Json &primitive, const Json &attributes,
                                                          std::size_t count, const std::string &where) const
{
    Eigen::Vector4f base = Eigen::Vector4f::Ones();
    const auto material = glbCount(primitive, "material", -1);
    if (!material)
        return mDocument.error(where, "its material is no index");
    if (*material >= 0) {
        const Result<const Json *> item = mDocument.item("materials", *material);
        if (!item)
            return item.error();
        const auto pbr = (*item)->find("pbrMetallicRoughness");
        if (pbr != (*item)->end() && pbr->is_object()) {
            const auto factor = glbNumbers(*pbr, "baseColorFactor", 4);
            if (!factor)
                return mDocument.error("materials[" + std::to_string(*material) + "]",
                                       "its base colour is not made of four numbers");
            for (std::size_t k = 0; k < factor->size(); ++k)
                base[int(k)] = float(std::clamp((*factor)[k], 0.0, 1.0));
        }
    }
    std::vector<Eigen::Vector4f> colours(count, base);
    const auto index = glbCount(attributes, "COLOR_0", -1);
    if (!index)
        return mDocument.error(where, "its colours are no accessor");
    if (*index < 0)
        return colours;
    const Result<const Json *> accessor = mDocument.item("accessors", *index);
    if (!accessor)
        return accessor.error();
    const std::size_t components = glbText(**accessor, "type") == "VEC3" ? 3 : 4;
    const auto values = readGlbAccessor(mDocument, *index, components == 3 ? "VEC3" : "VEC4", components);
    if (!values)
        return values.error();
    if (values->size() != count * components)
        return mDocument.error(where, "it has not as many colours as positions");
    for (std::size_t v = 0; v < count; ++v)
        for (std::size_t k = 0; k < components; ++k) {
            const double value = (*values)[v * components + k];
            if (!std::isfinite(value))
                return mDocument.error(where, "a colour is not a finite number");
            colours[v][int(k)] *= float(std::clamp(value, 0.0, 1.0));
        }
    return colours;
}

std::optional<Error> GlbReader::addPrimitive(const Json &primitive, const Eigen::Affine3d &sceneFromMesh,
                                             const std::string &where)
{
    const auto mode = glbCount(primitive, "mode", Triangles);
    const auto attributes = primitive.find("attributes");
    if (!mode || attributes == primitive.end() || !attributes->is_object())
        return mDocument.error(where, "it has no attributes, or a wrong mode");
    if (*mode < Triangles || *mode > TriangleFan)
        return std::nullopt; // points and lines
    const auto positionIndex = glbCount(*attributes, "POSITION", -1);
    if (!positionIndex || *positionIndex < 0)
        return mDocument.error(where, "it has no positions");
    const Result<std::vector<double>> positions = readGlbAccessor(mDocument, *positionIndex, "VEC3", 3);
    if (!positions)
        return positions.error();

    const std::int64_t base = mBuilder.vertexCount();
    const std::int64_t count = std::int64_t(positions->size() / 3);
    std::vector<Eigen::Vector4f> colours;
    if (mWithColours) {
        Result<std::vector<Eigen::Vector4f>> read =
            coloursOf(primitive, *attributes, std::size_t(count), where);
        if (!read)
            return read.error();
        colours = std::move(*read);
    }
    for (std::int64_t v = 0; v < count; ++v) {
        const double *p = positions->data() + 3 * v;
        const Vec3 position = sceneFromMesh * Vec3(p[0], p[1], p[2]);
        if (const auto fault = mWithColours ? mBuilder.addVertex(position, colours[std::size_t(v)])
                                            : mBuilder.addVertex(position))
            return Error{fault->code, readingTheMesh, fault->problem, fault->remedy,
                         mDocument.name + ": " + where};
    }
    std::vector<std::int64_t> corners;
    if (primitive.contains("indices")) {
        const auto index = glbCount(primitive, "indices", -1);
        if (!index)
            return mDocument.error(where, "its indices are no accessor");
        const Result<std::vector<double>> indices = readGlbAccessor(mDocument, *index, "SCALAR", 1);
        if (!indices)
            return indices.error();
        corners.reserve(indices->size());
        for (const double i : *indices) {
            if (!(i >= 0.0 && i < double(count)) || i != double(std::int64_t(i)))
                return mDocument.error(where, "it uses a vertex that it does not have");
            corners.push_back(base + std::int64_t(i));
        }
    } else {
        corners.reserve(std::size_t(count));
        for (std::int64_t v = 0; v < count; ++v)
            corners.push_back(base + v);
    }
    const bool mirrored = sceneFromMesh.linear().determinant() < 0.0;
    return addTriangles(corners, *mode, mirrored, where);
}

std::optional<Error> GlbReader::addMesh(std::int64_t index, const Eigen::Affine3d &sceneFromMesh)
{
    const Result<const Json *> mesh = mDocument.item("meshes", index);
    if (!mesh)
        return mesh.error();
    const std::string where = "meshes[" + std::to_string(index) + "]";
    const auto primitives = (*mesh)->find("primitives");
    if (primitives == (*mesh)->end() || !primitives->is_array())
        return mDocument.error(where, "it has no primitives");
    for (std::size_t p = 0; p < primitives->size(); ++p) {
        const std::string at = where + ".primitives[" + std::to_string(p) + "]";
        if (mControl.isCancelled())
            return cancelledError(readingTheMesh);
        if (!(*primitives)[p].is_object())
            return mDocument.error(at, "it is no object");
        if (const auto error = addPrimitive((*primitives)[p], sceneFromMesh, at))
            return error;
    }
    return std::nullopt;
}

Result<void> GlbReader::read()
{
    if (const auto error = refuseCompression())
        return *error;
    const auto roots = rootNodes();
    if (!roots)
        return roots.error();
    std::vector<Placed> stack; // explicit: the depth of the tree is the file's to choose
    for (auto root = roots->rbegin(); root != roots->rend(); ++root)
        stack.push_back({*root, Eigen::Affine3d::Identity()});
    const auto nodes = mDocument.root.find("nodes");
    std::vector<char> visited(nodes != mDocument.root.end() && nodes->is_array() ? nodes->size() : 0, 0);
    while (!stack.empty()) {
        const Placed placed = stack.back();
        stack.pop_back();
        const Result<const Json *> item = mDocument.item("nodes", placed.node);
        if (!item)
            return item.error();
        const std::string where = "nodes[" + std::to_string(placed.node) + "]";
        if (visited[std::size_t(placed.node)])
            return mDocument.error(where, "it has several parents or is its own ancestor");
        visited[std::size_t(placed.node)] = 1;
        const auto parentFromThis = parentFromNode(**item, where);
        if (!parentFromThis)
            return parentFromThis.error();
        const Eigen::Affine3d sceneFromThis = placed.sceneFromParent * *parentFromThis;
        if ((*item)->contains("mesh")) {
            const auto mesh = glbCount(**item, "mesh", -1);
            if (!mesh)
                return mDocument.error(where, "its mesh is no index");
            if (const auto error = addMesh(*mesh, sceneFromThis))
                return *error;
        }
        const auto children = indexList(**item, "children", where);
        if (!children)
            return children.error();
        for (auto child = children->rbegin(); child != children->rend(); ++child)
            stack.push_back({*child, sceneFromThis});
    }
    mBuilder.mergeEqualVertices();
    return {};
}

/// Whether anything in it has a colour.
bool hasColours(const GlbDocument &document)
{
    for (const char *list : {"materials", "meshes"})
        if (const auto items = document.root.find(list); items != document.root.end()) {
            const std::string text = items->dump(-1, ' ', false, Json::error_handler_t::replace);
            if (text.find("\"baseColorFactor\"") != std::string::npos ||
                text.find("\"COLOR_0\"") != std::string::npos)
                return true;
        }
    return false;
}

} // namespace

Result<TriangleMesh> readGlbMesh(std::string_view bytes, const std::string &name, const JobControl &control)
{
    const Result<GlbDocument> document = openGlb(bytes, name);
    if (!document)
        return document.error();
    GlbReader reader(*document, false, control);
    if (const Result<void> read = reader.read(); !read)
        return read.error();
    return reader.builder().finish(name);
}

Result<ColouredMesh> readColouredGlbMesh(std::string_view bytes, const std::string &name,
                                         const JobControl &control)
{
    const Result<GlbDocument> document = openGlb(bytes, name);
    if (!document)
        return document.error();
    GlbReader reader(*document, hasColours(*document), control);
    if (const Result<void> read = reader.read(); !read)
        return read.error();
    return reader.builder().finishColoured(name);
}

} // namespace ductus
