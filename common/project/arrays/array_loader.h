// ArrayLoader: arrays out of the buffers of one project, every buffer unpacked and its hash checked once.
#pragma once

#include "project/arrays/array_reference.h"
#include "project/arrays/buffer_store.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <type_traits>

namespace ductus {

static_assert(std::endian::native == std::endian::little, "buffers are little-endian and copied as they are");

class ArrayLoader
{
public:
    /// \a fileName starts the places of errors; \a store must outlive the loader.
    ArrayLoader(const BufferStore &store, std::string fileName);

    /// The array \a key of \a parent refers to. \a columns: what the shape must be besides the number of
    /// rows; 1 means a one-dimensional array. Fails through \a parent: type or shape not as expected, buffer
    /// missing or damaged, out of its bounds, numbers that are not finite.
    template <typename T>
    std::vector<T> load(const JsonReader &parent, std::string_view key, std::uint64_t columns)
    {
        std::vector<T> values;
        const std::span<const std::byte> bytes = locate(parent, key, arrayTypeOf<T>(), columns);
        values.resize(bytes.size() / sizeof(T));
        if (!values.empty())
            std::memcpy(values.data(), bytes.data(), bytes.size());
        if constexpr (std::is_floating_point_v<T>) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (!std::isfinite(values[i])) {
                    parent.failAt(key, "element " + std::to_string(i) + " is not a finite number");
                    return {};
                }
            }
        }
        return values;
    }

    /// Hashes of all buffers arrays were read from.
    const std::set<std::string> &usedBuffers() const { return mUsed; }

private:
    std::span<const std::byte> locate(const JsonReader &parent, std::string_view key, ArrayType type,
                                      std::uint64_t columns);
    const Bytes *buffer(const JsonReader &reader, const std::string &hash);

    const BufferStore &mStore;
    std::string mFileName;
    std::map<std::string, Bytes> mUnpacked;
    std::set<std::string> mUsed;
    std::uint64_t mLoadedBytes = 0;
};

} // namespace ductus
