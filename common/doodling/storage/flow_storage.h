// Flow fields as arrays of a project: motions in 1/32 of a pixel in 16 bits (+-1000 pixels), confidences
// in 8.
#pragma once

#include "doodling/reconstruction/long_flow.h"
#include "project/arrays/array_loader.h"
#include "project/arrays/buffer_packer.h"

namespace ductus {

struct StoredFlow
{
    BufferPacker::Handle motions, confidences;
};

StoredFlow addFlow(const CompactFlow &flow, BufferPacker &packer);
/// \a packer is finished.
OrderedJson flowJson(const CompactFlow &flow, const StoredFlow &stored, const BufferPacker &packer);
/// Fails through \a reader.
CompactFlow flowFromJson(const JsonReader &reader, ArrayLoader &arrays);

} // namespace ductus
