// The header of a PLY file: which elements of which properties follow.
#pragma once

#include "formats/text/text_lines.h"

#include <string>
#include <vector>

namespace ductus {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::size_t plyTypeSize(PlyType type);

struct PlyProperty
{
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::UInt8; // of lists
};

struct PlyElement
{
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of a property by name, or -1.
    int indexOf(std::string_view name) const;
    /// The fewest bytes one item can take in a binary file.
    std::size_t leastBytes() const;
};

enum class PlyFormat { Ascii, BinaryLittleEndian, BinaryBigEndian };

struct PlyHeader
{
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
};

/// Reads up to and with the line "end_header".
Result<PlyHeader> readPlyHeader(TextLines &lines);

} // namespace ductus
