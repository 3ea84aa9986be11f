// From another program's painting to ours: each paint layer that holds strokes becomes a stack with one
// substrate. painting.md section 4.
#pragma once

#include "formats/painting_file.h"
#include "painting/scene/painting.h"

namespace ductus {

struct ImportedPainting
{
    Painting painting;              // keeps the invariants
    std::vector<std::string> notes; // what a painting cannot express, for the import report
};

/// Strokes keep their points; the place of a layer, with all groups around it, goes to its elements, so that
/// scene units are the file's. Visibility and opacity inherit from groups; frames stay frames; pictures
/// become reference pictures. Strokes without points are left out with a note. Not imported, with a note:
/// keys of the file's animation, rotational opacity.
Result<ImportedPainting> importPainting(const PaintingFile &file);

} // namespace ductus
