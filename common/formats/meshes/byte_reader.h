// Bounds-checked little- or big-endian reading from memory, and little-endian writing.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace ductus {

class ByteReader
{
public:
    explicit ByteReader(std::string_view bytes, std::endian order = std::endian::little)
        : mBytes(bytes), mOrder(order)
    {
    }

    std::size_t offset() const { return mOffset; }
    std::size_t remaining() const { return mBytes.size() - mOffset; }

    /// False, with \a value untouched, if fewer bytes are left than the type has.
    template <typename T>
    bool read(T &value)
    {
        static_assert(std::is_arithmetic_v<T>);
        if (remaining() < sizeof(T))
            return false;
        char raw[sizeof(T)];
        std::memcpy(raw, mBytes.data() + mOffset, sizeof(T));
        if (mOrder != std::endian::native)
            std::reverse(raw, raw + sizeof(T));
        std::memcpy(&value, raw, sizeof(T));
        mOffset += sizeof(T);
        return true;
    }

    bool skip(std::size_t count)
    {
        if (remaining() < count)
            return false;
        mOffset += count;
        return true;
    }

private:
    std::string_view mBytes;
    std::endian mOrder;
    std::size_t mOffset = 0;
};

/// Appends \a value in little-endian order.
template <typename T>
void appendLittleEndian(std::string &bytes, T value)
{
    static_assert(std::is_arithmetic_v<T>);
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (std::endian::native != std::endian::little)
        std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
}

} // namespace ductus
