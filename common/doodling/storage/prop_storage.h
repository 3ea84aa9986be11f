// Props as JSON of a canvas: the painting stands in it whole, as in a painting document. Fields:
// resources/schemas/doodle.schema.json, "prop".
#pragma once

#include "doodling/prop/prop.h"
#include "project/arrays/array_loader.h"
#include "project/arrays/buffer_packer.h"

namespace ductus {

/// Its arrays are slots (painting/storage/array_slots.h) until \a packer is finished.
OrderedJson propJsonWithSlots(const Prop &prop, BufferPacker &packer);

/// Fails through \a reader.
std::shared_ptr<const Prop> propFromJson(const JsonReader &reader, ArrayLoader &arrays);

/// What a reader would refuse, in words; empty: nothing.
std::string storedPropProblem(const Prop &prop);

} // namespace ductus
