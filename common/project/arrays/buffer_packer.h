// BufferPacker: arrays into buffers. Small arrays share a buffer, so that ten thousand strokes do not make
// ten thousand entries; which arrays share depends on nothing but their order and sizes.
//
//     BufferPacker packer;
//     const auto points = packer.add<double>(coordinates, {n, 3}, "sketch unit");
//     packer.finish();
//     json["points"] = packer.reference(points).toJson();
#pragma once

#include "project/arrays/array_reference.h"
#include "project/arrays/buffer_store.h"

#include <span>

namespace ductus {

class BufferPacker
{
public:
    using Handle = std::size_t;

    template <typename T>
    Handle add(std::span<const T> values, std::vector<std::uint64_t> shape, std::string unit = {})
    {
        ArrayReference reference{{}, 0, arrayTypeOf<T>(), std::move(shape), std::move(unit)};
        DUCTUS_ASSERT(reference.count() == values.size());
        return addBytes(std::move(reference), std::as_bytes(values));
    }

    /// The next array starts a new buffer: equal meshes in two documents then become equal buffers.
    void startBuffer();

    /// All buffers made so far; to be called once, before reference().
    void finish() { startBuffer(); }

    const ArrayReference &reference(Handle handle) const { return mReferences[handle]; }

    /// Bytes of each buffer by its hash.
    const std::map<std::string, Bytes> &buffers() const { return mBuffers; }

private:
    Handle addBytes(ArrayReference reference, std::span<const std::byte> bytes);

    std::vector<ArrayReference> mReferences;
    std::size_t mFirstOpen = 0; // references from here on wait for the hash of mOpen
    Bytes mOpen;
    std::map<std::string, Bytes> mBuffers;
};

} // namespace ductus
