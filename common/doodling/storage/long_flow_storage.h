// Flow over long gaps and small pictures as arrays of a project. Projects without them are tracked with the
// flow between neighbours alone.
#pragma once

#include "doodling/reconstruction/shot.h"
#include "doodling/storage/flow_storage.h"

namespace ductus {

struct StoredLongFlows
{
    std::vector<StoredFlow> forward, backward; // in the order of Shot::longFlows
    std::vector<BufferPacker::Handle> lightness, colours;
};

StoredLongFlows addLongFlows(const Shot &shot, BufferPacker &packer);
/// Members "longFlows" and "pictures" of \a json. \a packer is finished.
void writeLongFlows(const Shot &shot, const StoredLongFlows &stored, const BufferPacker &packer,
                    OrderedJson &json);
/// Into a shot of \a frameCount frames. Fails through \a reader.
void readLongFlows(const JsonReader &reader, ArrayLoader &arrays, int frameCount, Shot &shot);

} // namespace ductus
