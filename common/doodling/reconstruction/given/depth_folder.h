// Depth maps made elsewhere, one a frame: a folder of 16-bit PNG, EXR or NumPy files in name order. Depth
// along z in any unit that is the same in all of them; 0, 65535 (PNG) and what is not finite is not known.
#pragma once

#include "base/job_control.h"
#include "base/result.h"

#include <filesystem>
#include <vector>

namespace ductus {

struct GivenDepth
{
    int width = 0, height = 0;
    std::vector<float> depths; // row by row; 0: not known
};

/// The files of a folder in name order. FileNotFound, TooLittleData (none, or another number than
/// \a frameCount).
Result<std::vector<std::filesystem::path>> depthFiles(const std::filesystem::path &folder, int frameCount);

/// Unsupported (8 bits), Malformed.
Result<GivenDepth> readDepthFile(const std::filesystem::path &path);

/// NumPy's .npy: two dimensions, float32, float64 or uint16, rows first.
Result<GivenDepth> parseNpy(std::string_view bytes, const std::string &name);

} // namespace ductus
