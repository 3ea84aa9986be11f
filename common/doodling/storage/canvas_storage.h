// Canvases and what is drawn on them as JSON of a doodle document; points of strokes in buffers. Fields:
// resources/schemas/doodle.schema.json, "scene".
#pragma once

#include "doodling/canvas/canvas.h"
#include "project/arrays/array_loader.h"
#include "project/arrays/buffer_packer.h"

#include <map>

namespace ductus {

/// The arrays of a scene in a packer, in the order sceneJson() asks for them.
struct StoredScene
{
    std::vector<BufferPacker::Handle> arrays;
    std::map<CanvasId, OrderedJson> paintings; // of props, with slots for their arrays
};

StoredScene addScene(const DoodleScene &scene, BufferPacker &packer);

/// After the packer was finished.
OrderedJson sceneJson(const DoodleScene &scene, const StoredScene &stored, const BufferPacker &packer);

/// Fails through \a reader for keyframes beyond \a frameCount or out of order and for marks that could not
/// have been drawn.
DoodleScene sceneFromJson(const JsonReader &reader, ArrayLoader &arrays, int frameCount);

/// What a reader would refuse, in words; empty: nothing.
std::string sceneProblem(const DoodleScene &scene, int frameCount);

} // namespace ductus
