// Tracking on synthetic clips whose truth is known: TAP-Vid's figures, with true depth and flow and with
// those that were found.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>

namespace ductus {

struct SyntheticSize
{
    int width = 480, height = 270, frames = 32;
    double spacing = 60.0; // pixels between the points that are tracked
};

/// Adds a table to \a report; failures are rows of it. Returns how many there were.
int runSyntheticSection(const SyntheticSize &size, nlohmann::ordered_json &report, std::ostream &out);

} // namespace ductus
