// Edits of strokes and meshes, in whatever kind of layer they are. Refusals as in layer_edits.h. Lists of
// elements may be in any order; what is added keeps the order the elements have in the painting.
#pragma once

#include "painting/scene/painting.h"

namespace ductus {

struct AddedElements
{
    Painting painting;
    std::vector<ElementId> elements; // in the order of the shapes
};

/// Appends to a drawing of the layer, in this order. No two need share a shape.
Result<AddedElements> addElements(const Painting &painting, LayerId layer,
                                  const std::vector<std::shared_ptr<const ElementShape>> &shapes,
                                  int drawing = 0, const Placement &placement = {});

Result<Painting> removeElements(const Painting &painting, const std::vector<ElementId> &elements);

/// To the end of another layer's drawing; a substrate's stroke becomes a colouring one and back. Elements
/// stay where they are in space unless the layers move differently.
Result<Painting> moveElements(const Painting &painting, const std::vector<ElementId> &elements, LayerId layer,
                              int drawing = 0);

/// Copies at the end of a layer's drawing: how highlights and shadows are made (V.4.1). Shapes are shared.
Result<AddedElements> duplicateElements(const Painting &painting, const std::vector<ElementId> &elements,
                                        LayerId layer, int drawing = 0);

/// Moves, turns and scales in the layer's space: \a change comes after each element's own placement.
Result<Painting> transformElements(const Painting &painting, const std::vector<ElementId> &elements,
                                   const Placement &change);

/// Other shapes for \a elements, one for all or one each; all else about them stays.
Result<Painting> replaceShapes(const Painting &painting, const std::vector<ElementId> &elements,
                               const std::vector<std::shared_ptr<const ElementShape>> &shapes);

/// One colour (linear RGB) for all points; opacities stay.
Result<Painting> recolourElements(const Painting &painting, const std::vector<ElementId> &elements,
                                  const Eigen::Vector3f &colour);

} // namespace ductus
