// Parts of strokes: the eraser that takes away what it touches.
#pragma once

#include "painting/edit/element_edits.h"

namespace ductus {

/// Keeps parts of a stroke, each from a place along it to another, counted in points: 1.5 is half way between
/// the second and the third. The parts are strokes of their own where the stroke stood; none: it is removed.
/// Groups move the parts instead. Refused: meshes, locked layers, parts that are empty, overlap or are not in
/// order.
Result<AddedElements> cutStroke(const Painting &painting, ElementId element,
                                const std::vector<std::pair<double, double>> &kept);

} // namespace ductus
