#include "painting/storage/array_slots.h"

namespace ductus {

namespace {

constexpr char slotKey[] = "$array"; // no member of a painting begins with $

} // namespace

OrderedJson arraySlot(BufferPacker::Handle handle)
{
    return {{slotKey, handle}};
}

void resolveArrays(OrderedJson &json, const BufferPacker &packer)
{
    if (json.is_object() && json.size() == 1 && json.begin().key() == slotKey) {
        json = packer.reference(json.begin().value().get<BufferPacker::Handle>()).toJson();
        return;
    }
    if (json.is_structured()) {
        for (OrderedJson &member : json)
            resolveArrays(member, packer);
    }
}

} // namespace ductus
