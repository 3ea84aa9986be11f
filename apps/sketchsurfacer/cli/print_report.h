// What the print panel says, in numbers.
#pragma once

#include "geometry/inspection/print_check.h"

#include <nlohmann/json.hpp>

namespace ductus {

/// Millimetres in truth, at \a metresPerUnit; places in the unit of the mesh. What was not measured is null.
nlohmann::ordered_json printReport(const PrintCheck &check, double metresPerUnit);

/// The same in a few lines for people.
std::string printLines(const PrintCheck &check, double metresPerUnit);

} // namespace ductus
