#include "formats/meshes/ply_header.h"

#include "formats/text/number_text.h"

#include <utility>

namespace ductus {

namespace {

constexpr std::size_t mostElements = 64;
constexpr std::size_t mostProperties = 256;

bool plyTypeFromName(std::string_view name, PlyType &type)
{
    static constexpr std::pair<std::string_view, PlyType> types[] = {
        {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::UInt8},
        {"uint8", PlyType::UInt8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
        {"ushort", PlyType::UInt16},  {"uint16", PlyType::UInt16},   {"int", PlyType::Int32},
        {"int32", PlyType::Int32},    {"uint", PlyType::UInt32},     {"uint32", PlyType::UInt32},
        {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
        {"float64", PlyType::Float64}};
    for (const auto &[known, value] : types)
        if (name == known) {
            type = value;
            return true;
        }
    return false;
}

const char *const exportAgain = "Correct this line or export the mesh again";

std::optional<Error> readFormat(const TextLines &lines, Words &words, PlyHeader &header)
{
    const std::string_view name = words.next();
    if (name == "ascii")
        header.format = PlyFormat::Ascii;
    else if (name == "binary_little_endian")
        header.format = PlyFormat::BinaryLittleEndian;
    else if (name == "binary_big_endian")
        header.format = PlyFormat::BinaryBigEndian;
    else
        return lines.error(ErrorCode::Unsupported, "the PLY format " + inQuotes(name) + " is not known",
                           exportAgain);
    return std::nullopt;
}

std::optional<Error> readElement(const TextLines &lines, Words &words, PlyHeader &header)
{
    PlyElement element;
    element.name = std::string(words.next());
    const std::string_view count = words.next();
    if (readInteger(count, element.count) != NumberFault::None || element.count < 0)
        return lines.error(ErrorCode::Malformed, "the number of items is " + inQuotes(count), exportAgain);
    if (header.elements.size() >= mostElements)
        return lines.error(ErrorCode::Malformed, "there are too many elements", exportAgain);
    header.elements.push_back(std::move(element));
    return std::nullopt;
}

std::optional<Error> readProperty(const TextLines &lines, Words &words, PlyHeader &header)
{
    if (header.elements.empty())
        return lines.error(ErrorCode::Malformed, "there is a property before the first element", exportAgain);
    PlyProperty property;
    std::string_view type = words.next();
    if (type == "list") {
        property.isList = true;
        const std::string_view countType = words.next();
        if (!plyTypeFromName(countType, property.countType) || property.countType >= PlyType::Float32)
            return lines.error(ErrorCode::Malformed,
                               inQuotes(countType) + " is no type for the length of a list", exportAgain);
        type = words.next();
    }
    if (!plyTypeFromName(type, property.type))
        return lines.error(ErrorCode::Malformed, inQuotes(type) + " is no PLY type", exportAgain);
    property.name = std::string(words.next());
    if (header.elements.back().properties.size() >= mostProperties)
        return lines.error(ErrorCode::Malformed, "there are too many properties", exportAgain);
    header.elements.back().properties.push_back(std::move(property));
    return std::nullopt;
}

} // namespace

std::size_t plyTypeSize(PlyType type)
{
    switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
        return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
        return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
        return 4;
    case PlyType::Float64:
        return 8;
    }
    return 8;
}

int PlyElement::indexOf(std::string_view wanted) const
{
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == wanted)
            return int(i);
    return -1;
}

std::size_t PlyElement::leastBytes() const
{
    std::size_t bytes = 0;
    for (const PlyProperty &p : properties)
        bytes += plyTypeSize(p.isList ? p.countType : p.type);
    return bytes;
}

Result<PlyHeader> readPlyHeader(TextLines &lines)
{
    PlyHeader header;
    bool hasFormat = false;
    std::string_view line;
    while (lines.next(line)) {
        Words words(line);
        const std::string_view keyword = words.next();
        std::optional<Error> error;
        if (keyword == "format") {
            hasFormat = true;
            error = readFormat(lines, words, header);
        } else if (keyword == "element") {
            error = readElement(lines, words, header);
        } else if (keyword == "property") {
            error = readProperty(lines, words, header);
        } else if (keyword == "end_header") {
            if (!hasFormat)
                return lines.error(ErrorCode::Malformed, "the header has no format line", exportAgain);
            return header;
        } else if (keyword != "ply" && keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
            return lines.error(ErrorCode::Malformed, inQuotes(keyword) + " is no word of a PLY header",
                               exportAgain);
        }
        if (error)
            return *error;
    }
    if (lines.failure())
        return *lines.failure();
    return lines.error(ErrorCode::Malformed, "the file ends before end_header",
                       "The file seems cut off: copy or export it again");
}

} // namespace ductus
