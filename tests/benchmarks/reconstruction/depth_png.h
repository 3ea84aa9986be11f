// 16-bit grey PNG, as depth cameras write it; formats/png_file.h makes 8 bits of everything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ductus {

struct DepthPicture
{
    int width = 0, height = 0;
    std::vector<std::uint16_t> values; // row by row
};

/// Empty if it cannot be read.
DepthPicture readDepthPng(const std::filesystem::path &path);

} // namespace ductus
