// Another program's painting or mesh added to the painting that is open, as stacks of its own.
#pragma once

#include "layerpainter/document/import_file.h"
#include "layerpainter/document/painting_document.h"

namespace ductus {

struct AddedImport
{
    int stacks = 0;
    int strokes = 0;
    bool leftFramesOut = false; // of frame-by-frame layers only the first drawing came along
};

/// One step of the history, named after the file; actions, so that the log plays it again. Refused actions
/// are told by the document; what was added before stays undoable as that step.
AddedImport addImported(PaintingDocument &document, const ImportedFile &file);

} // namespace ductus
