// The targets of surfacing.md section 3 beside what was measured: the worst of all rows, and by how much it
// misses.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>

namespace ductus {

/// \a report: by section, as bench_surfacing writes it. Targets whose section did not run are left out.
void printTargetSummary(const nlohmann::ordered_json &report, std::ostream &out);

} // namespace ductus
