// PNG in and out (libpng), 8-bit RGBA.
#pragma once

#include "base/result.h"
#include "imaging/image.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace ductus {

Result<std::vector<std::byte>> encodePng(const Image &image);
Result<Image> decodePng(std::span<const std::byte> bytes);

/// Written beside the target and renamed.
Result<void> writePng(const Image &image, const std::filesystem::path &path);
Result<Image> readPng(const std::filesystem::path &path);

} // namespace ductus
