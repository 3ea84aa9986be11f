// Tracking of filmed things whose motion is known (photo_clips.h): how near with one and two keyframes, and
// whether what is hidden is said to be.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

namespace ductus {

/// \a data: the folder with clips/davis. Says so and adds nothing where it is absent. Returns how many
/// measurements failed.
int runPhotoSection(const std::filesystem::path &data, nlohmann::ordered_json &report, std::ostream &out);

} // namespace ductus
