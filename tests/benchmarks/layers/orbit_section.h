// What turning a large import costs: frames of 57,000 strokes, exact, as the window shows them still, and as
// it shows them while the view turns.
#pragma once

#include <nlohmann/json.hpp>

namespace ductus {

/// Prints a table; in the current context.
nlohmann::json measureOrbit(int strokes);

} // namespace ductus
