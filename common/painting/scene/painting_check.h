// The invariants of a painting. What comes from a file is checked once; edits keep them (tests check after
// each).
#pragma once

#include "painting/scene/painting.h"

namespace ductus {

/// InvalidArgument with the layer's name as the place for the first broken promise of the structs' comments:
/// ids that repeat, are invalid or not below nextId; numbers out of range or not finite; references to what
/// is not there; keys out of order; a substrate in the scene stack or none in another.
Result<void> checkPainting(const Painting &painting);

// What edits check instead of everything.

/// A layer of \a painting without its elements.
Result<void> checkLayer(const Painting &painting, const Layer &layer);
Result<void> checkShape(const ElementShape &shape);

} // namespace ductus
