// What is in a filmed scene, counted: for `doodlestudio info`.
#pragma once

#include "doodling/storage/doodle_content.h"

#include <nlohmann/json.hpp>

namespace ductus {

nlohmann::ordered_json doodleSummary(const DoodleContent &content);

/// The same for people, a line each.
std::string doodleLines(const DoodleContent &content);

} // namespace ductus
