// How a document names an array: {"buffer": sha256, "offset": bytes, "type": "float64", "shape": [n, 3],
// "unit": "m"}.
#pragma once

#include "project/json/json_reader.h"
#include "project/json/json_writer.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

enum class ArrayType { Uint8, Uint16, Int32, Uint32, Float32, Float64 };

std::string_view arrayTypeName(ArrayType type);
std::size_t elementSize(ArrayType type); // bytes

template <typename T>
constexpr ArrayType arrayTypeOf()
{
    if constexpr (std::is_same_v<T, std::uint8_t>)
        return ArrayType::Uint8;
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return ArrayType::Uint16;
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return ArrayType::Int32;
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return ArrayType::Uint32;
    else if constexpr (std::is_same_v<T, float>)
        return ArrayType::Float32;
    else {
        static_assert(std::is_same_v<T, double>, "no array type for this");
        return ArrayType::Float64;
    }
}

struct ArrayReference
{
    std::string buffer;       // sha256 of the buffer's bytes
    std::uint64_t offset = 0; // bytes into the buffer
    ArrayType type = ArrayType::Float64;
    std::vector<std::uint64_t> shape; // row-major
    std::string unit;                 // "" where the values have none

    /// Elements, or nothing if the product overflows 64 bits.
    std::optional<std::uint64_t> count() const;
    OrderedJson toJson() const;
    /// Fails through \a reader.
    static ArrayReference fromJson(const JsonReader &reader);
};

} // namespace ductus
