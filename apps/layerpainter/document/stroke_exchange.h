// Strokes of a painting for the other apps, and theirs for a painting.
#pragma once

#include "document/stroke_clipboard.h"
#include "painting/action/action.h"
#include "project/project.h"

namespace ductus {

/// The strokes among \a elements where they stand at the beginning, in the order of layers; meshes are left
/// out: nobody drew them.
CopiedStrokes copiedElements(const Painting &painting, const std::vector<ElementId> &elements);

/// All strokes of \a layer's first drawing.
std::vector<ElementId> elementsOf(const Painting &painting, LayerId layer);

/// Draws \a strokes into \a layer. What has no width or colour gets \a halfWidth (scene units) times its
/// pressure, and \a colour.
act::Draw drawnStrokes(const CopiedStrokes &strokes, const Painting &painting, LayerId layer,
                       double halfWidth, const Eigen::Vector3f &colour);

/// A project with \a strokes as a sketch, for SketchSurfacer.
Project sketchProject(const CopiedStrokes &strokes, const std::string &name);

} // namespace ductus
