// Depth of every frame as arrays of a project, bit for bit. Projects without it are flat, at the scene's
// depth.
#pragma once

#include "doodling/reconstruction/shot.h"
#include "project/arrays/array_loader.h"
#include "project/arrays/buffer_packer.h"

namespace ductus {

struct StoredDepths
{
    std::vector<BufferPacker::Handle> disparities,
        objects; // one a frame each; objects only where there are any
};

StoredDepths addDepths(const Shot &shot, BufferPacker &packer);
/// Member "depths" of \a json, if there are any. \a packer is finished.
void writeDepths(const Shot &shot, const StoredDepths &stored, const BufferPacker &packer, OrderedJson &json);
/// Into a shot of \a frameCount frames. Fails through \a reader.
void readDepths(const JsonReader &reader, ArrayLoader &arrays, int frameCount, Shot &shot);

} // namespace ductus
