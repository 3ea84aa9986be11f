#include "formats/meshes/glb_document.h"

#include "formats/meshes/byte_reader.h"
#include "formats/meshes/mesh_builder.h"

#include <cmath>

namespace ductus {

using Json = nlohmann::json;

namespace {

constexpr std::uint32_t chunkJson = 0x4E4F534A;
constexpr std::uint32_t chunkBinary = 0x004E4942;

struct Component
{
    std::size_t size = 0;
    double largest = 0.0; // divisor of normalised integers
    double (*read)(ByteReader &) = nullptr;
};

template <typename T>
double readValue(ByteReader &reader)
{
    T value = 0;
    reader.read(value); // the caller has checked the bounds of the whole accessor
    return double(value);
}

std::optional<Component> componentOf(std::int64_t type)
{
    switch (type) {
    case 5120:
        return Component{1, 127.0, readValue<std::int8_t>};
    case 5121:
        return Component{1, 255.0, readValue<std::uint8_t>};
    case 5122:
        return Component{2, 32767.0, readValue<std::int16_t>};
    case 5123:
        return Component{2, 65535.0, readValue<std::uint16_t>};
    case 5125:
        return Component{4, 4294967295.0, readValue<std::uint32_t>};
    case 5126:
        return Component{4, 1.0, readValue<float>};
    default:
        return std::nullopt;
    }
}

/// The bytes of a buffer view and the step between its items (0: packed).
struct View
{
    std::string_view bytes;
    std::size_t stride = 0;
};

Result<View> openView(const GlbDocument &document, std::int64_t index)
{
    const std::string where = "bufferViews[" + std::to_string(index) + "]";
    const Result<const Json *> view = document.item("bufferViews", index);
    if (!view)
        return view.error();
    const auto buffer = glbCount(**view, "buffer", -1);
    if (buffer != 0)
        return document.error(where, "its data is not in the file's own buffer", ErrorCode::Unsupported);
    const Result<const Json *> bufferItem = document.item("buffers", 0);
    if (!bufferItem)
        return bufferItem.error();
    if ((*bufferItem)->contains("uri"))
        return document.error("buffers[0]", "the data is in another file", ErrorCode::Unsupported);
    const auto offset = glbCount(**view, "byteOffset", 0);
    const auto length = glbCount(**view, "byteLength", -1);
    const auto stride = glbCount(**view, "byteStride", 0);
    if (!offset || !length || !stride || *length < 0 || *stride > 252)
        return document.error(where, "its numbers are missing or wrong");
    if (std::uint64_t(*offset) > document.binary.size() ||
        std::uint64_t(*length) > document.binary.size() - std::uint64_t(*offset))
        return document.error(where, "it reaches beyond the end of the data");
    return View{document.binary.substr(std::size_t(*offset), std::size_t(*length)), std::size_t(*stride)};
}

} // namespace

Error GlbDocument::error(const std::string &where, const std::string &problem, ErrorCode code) const
{
    return {code, readingTheMesh, problem,
            code == ErrorCode::Unsupported ? "Export an uncompressed .glb with everything in one file, or OBJ"
                                           : "Repair the scene or export it again",
            where.empty() ? name : name + ": " + where};
}

Result<const Json *> GlbDocument::item(const char *list, std::int64_t index) const
{
    const std::string where = std::string(list) + "[" + std::to_string(index) + "]";
    const auto array = root.find(list);
    if (array == root.end() || !array->is_array() || index < 0 || std::uint64_t(index) >= array->size())
        return error(where, "there is no such item");
    const Json &found = (*array)[std::size_t(index)];
    if (!found.is_object())
        return error(where, "it is no object");
    return &found;
}

Result<GlbDocument> openGlb(std::string_view bytes, const std::string &name)
{
    GlbDocument document;
    document.name = name;
    ByteReader reader(bytes);
    std::uint32_t magic = 0, version = 0, length = 0;
    if (!reader.read(magic) || !reader.read(version) || !reader.read(length))
        return document.error("", "the file is shorter than the header of a GLB file");
    if (version != 2)
        return document.error("",
                              "this is glTF version " + std::to_string(version) + ", only version 2 is known",
                              ErrorCode::Unsupported);
    if (length > bytes.size())
        return document.error("", "the file is cut off: " + std::to_string(length) +
                                      " bytes are announced, " + std::to_string(bytes.size()) + " are there");
    bool hasJson = false;
    bool hasBinary = false;
    while (reader.remaining() > 0 && reader.offset() < length) {
        std::uint32_t size = 0, type = 0;
        if (!reader.read(size) || !reader.read(type) || reader.remaining() < size)
            return document.error("byte " + std::to_string(reader.offset()),
                                  "a chunk reaches beyond the file's end");
        const std::string_view content = bytes.substr(reader.offset(), size);
        reader.skip(size);
        if (type == chunkJson && !hasJson) {
            document.root = Json::parse(content, nullptr, false);
            hasJson = true;
        } else if (type == chunkBinary && !hasBinary) {
            document.binary = content;
            hasBinary = true;
        }
    }
    if (!hasJson || !document.root.is_object())
        return document.error("", "its JSON part is missing or damaged");
    return document;
}

std::optional<std::int64_t> glbCount(const Json &object, const char *key, std::int64_t fallback)
{
    const auto found = object.find(key);
    if (found == object.end())
        return fallback;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 0x7fffffffffffffffull)
        return std::nullopt;
    return found->get<std::int64_t>();
}

std::string glbText(const Json &object, const char *key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<std::vector<double>> glbNumbers(const Json &object, const char *key, std::size_t size)
{
    const auto found = object.find(key);
    if (found == object.end())
        return std::vector<double>();
    if (!found->is_array() || found->size() != size)
        return std::nullopt;
    std::vector<double> numbers;
    for (const Json &number : *found) {
        if (!number.is_number() || !std::isfinite(number.get<double>()))
            return std::nullopt;
        numbers.push_back(number.get<double>());
    }
    return numbers;
}

Result<std::vector<double>> readGlbAccessor(const GlbDocument &document, std::int64_t index, const char *type,
                                            std::size_t components)
{
    const std::string where = "accessors[" + std::to_string(index) + "]";
    const Result<const Json *> item = document.item("accessors", index);
    if (!item)
        return item.error();
    const Json &accessor = **item;
    if (accessor.contains("sparse") || !accessor.contains("bufferView"))
        return document.error(where, "its values are stored sparsely or compressed", ErrorCode::Unsupported);
    if (glbText(accessor, "type") != type)
        return document.error(where, std::string("it is not of type ") + type);
    const auto viewIndex = glbCount(accessor, "bufferView", -1);
    const auto offset = glbCount(accessor, "byteOffset", 0);
    const auto count = glbCount(accessor, "count", -1);
    const auto componentType = glbCount(accessor, "componentType", -1);
    const auto component = componentType ? componentOf(*componentType) : std::nullopt;
    if (!viewIndex || !offset || !count || *count < 0 || !component)
        return document.error(where, "its numbers are missing or wrong");
    const Result<View> view = openView(document, *viewIndex);
    if (!view)
        return view.error();

    const std::size_t itemSize = component->size * components;
    const std::size_t stride = view->stride > 0 ? view->stride : itemSize;
    if (stride < itemSize)
        return document.error(where, "its items overlap");
    const std::size_t size = view->bytes.size();
    const bool fits =
        *count == 0 || (std::uint64_t(*offset) <= size && size - std::size_t(*offset) >= itemSize &&
                        std::uint64_t(*count - 1) <= (size - std::size_t(*offset) - itemSize) / stride);
    if (!fits)
        return document.error(where, "it reaches beyond the end of its data");
    const auto normalized = accessor.find("normalized");
    const bool scale = normalized != accessor.end() && normalized->is_boolean() && normalized->get<bool>();

    std::vector<double> values;
    values.reserve(std::size_t(*count) * components);
    for (std::size_t i = 0; i < std::size_t(*count); ++i) {
        ByteReader reader(view->bytes.substr(std::size_t(*offset) + i * stride, itemSize));
        for (std::size_t c = 0; c < components; ++c) {
            const double value = component->read(reader);
            values.push_back(scale ? std::max(-1.0, value / component->largest) : value);
        }
    }
    return values;
}

} // namespace ductus
