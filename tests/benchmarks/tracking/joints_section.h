// Tracking of joints that people placed by hand on filmed animals [BADJA, Biggs 2018], as the thesis' second
// experiment: how near with one, two and four keyframes.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

namespace ductus {

/// \a data: the folder with clips/davis and clips/badja. Says so and adds nothing where it is absent. Returns
/// how many measurements failed.
int runJointsSection(const std::filesystem::path &data, nlohmann::ordered_json &report, std::ostream &out);

} // namespace ductus
