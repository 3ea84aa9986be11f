// Depth where the camera did not move and so measured none: a floor that rises to the horizon and a far
// backdrop. The same place of the world has the same depth in every frame, however the camera turns.
#pragma once

#include "doodling/reconstruction/shot.h"

namespace ductus {

/// One a cell of \a grid; 1 / scene unit.
std::vector<float> guessedDisparities(const Shot &shot, int frame, const CompactFlow &grid);

} // namespace ductus
