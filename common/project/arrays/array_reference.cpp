#include "project/arrays/array_reference.h"

#include "project/container/entry_name.h"

namespace ductus {

namespace {

constexpr std::pair<std::string_view, ArrayType> typeNames[] = {
    {"uint8", ArrayType::Uint8},   {"uint16", ArrayType::Uint16},   {"int32", ArrayType::Int32},
    {"uint32", ArrayType::Uint32}, {"float32", ArrayType::Float32}, {"float64", ArrayType::Float64},
};

} // namespace

std::string_view arrayTypeName(ArrayType type)
{
    return typeNames[std::size_t(type)].first;
}

std::size_t elementSize(ArrayType type)
{
    constexpr std::size_t sizes[] = {1, 2, 4, 4, 4, 8};
    return sizes[std::size_t(type)];
}

std::optional<std::uint64_t> ArrayReference::count() const
{
    std::uint64_t product = 1;
    for (std::uint64_t extent : shape) {
        if (__builtin_mul_overflow(product, extent, &product))
            return std::nullopt;
    }
    return product;
}

OrderedJson ArrayReference::toJson() const
{
    OrderedJson json = {
        {"buffer", buffer}, {"offset", offset}, {"type", arrayTypeName(type)}, {"shape", shape}};
    if (!unit.empty())
        json["unit"] = unit;
    return json;
}

ArrayReference ArrayReference::fromJson(const JsonReader &reader)
{
    ArrayReference reference;
    reference.buffer = reader.string("buffer", 64);
    if (!reader.failed() && !isSha256(reference.buffer))
        reader.failAt("buffer", "this is not a SHA-256 hash");
    reference.offset = reader.unsignedInteger("offset");
    reference.type = reader.oneOf<ArrayType>("type", typeNames);
    reference.shape = reader.unsignedIntegers("shape", 4);
    if (reader.has("unit"))
        reference.unit = reader.string("unit", 64);
    return reference;
}

} // namespace ductus
