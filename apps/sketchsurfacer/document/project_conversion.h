// A sketch with its decisions and result to and from the project file.
#pragma once

#include "project/project.h"
#include "sketchsurfacer/document/sketch_content.h"

namespace ductus {

struct StoredSketch
{
    Uuid documentId;
    SketchContent content;
    /// The finished surface alone, to be shown; the solver begins anew. Null if there was none.
    std::shared_ptr<const SurfacingState> state;
};

/// The first sketch-surface document of \a project. TooLittleData if there is none.
Result<StoredSketch> sketchFromProject(const Project &project);

/// Puts the sketch in the place of the document \a id, or beside the others. \a state may be null.
void putSketch(const SketchContent &content, const SurfacingState *state, const Uuid &id,
               const std::string &name, Project &project);

} // namespace ductus
