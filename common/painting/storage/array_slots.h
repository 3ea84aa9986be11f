// Arrays in JSON that is being written: a buffer's hash is known only when it is full, so first a number
// stands where the array's reference will be.
#pragma once

#include "project/arrays/buffer_packer.h"

namespace ductus {

/// What stands for the array \a handle until resolveArrays().
OrderedJson arraySlot(BufferPacker::Handle handle);

/// Replaces all slots in \a json by references; \a packer is finished.
void resolveArrays(OrderedJson &json, const BufferPacker &packer);

template <typename T>
OrderedJson addArray(BufferPacker &packer, const std::vector<T> &values, std::uint64_t columns = 1,
                     const char *unit = "")
{
    std::vector<std::uint64_t> shape{values.size() / columns};
    if (columns > 1)
        shape.push_back(columns);
    return arraySlot(packer.add<T>(values, std::move(shape), unit));
}

} // namespace ductus
