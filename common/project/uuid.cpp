#include "project/uuid.h"

#include <random>

namespace ductus {

namespace {

constexpr std::string_view hexDigits = "0123456789abcdef";

bool hyphenBefore(std::size_t byte)
{
    return byte == 4 || byte == 6 || byte == 8 || byte == 10;
}

} // namespace

Uuid Uuid::create()
{
    std::random_device device;
    Random random(std::uint64_t(device()) << 32 | device());
    Uuid uuid = from(random);
    for (std::size_t i = 0; i < 16; ++i) // the seed alone has but 64 bits
        uuid.bytes[i] ^= i == 6 ? device() & 0x0f : i == 8 ? device() & 0x3f : device() & 0xff;
    return uuid;
}

Uuid Uuid::from(Random &random)
{
    Uuid uuid;
    for (std::size_t i = 0; i < 16; i += 8) {
        const std::uint64_t word = random.next();
        for (std::size_t k = 0; k < 8; ++k)
            uuid.bytes[i + k] = std::uint8_t(word >> (8 * k));
    }
    uuid.bytes[6] = std::uint8_t((uuid.bytes[6] & 0x0f) | 0x40); // version 4
    uuid.bytes[8] = std::uint8_t((uuid.bytes[8] & 0x3f) | 0x80); // RFC variant
    return uuid;
}

std::optional<Uuid> Uuid::parse(std::string_view text)
{
    if (text.size() != 36)
        return std::nullopt;
    Uuid uuid;
    std::size_t position = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        if (hyphenBefore(i) && text[position++] != '-')
            return std::nullopt;
        const std::size_t high = hexDigits.find(text[position++]);
        const std::size_t low = hexDigits.find(text[position++]);
        if (high == std::string_view::npos || low == std::string_view::npos)
            return std::nullopt;
        uuid.bytes[i] = std::uint8_t(high << 4 | low);
    }
    return uuid;
}

std::string Uuid::text() const
{
    std::string out;
    for (std::size_t i = 0; i < 16; ++i) {
        if (hyphenBefore(i))
            out += '-';
        out += hexDigits[bytes[i] >> 4];
        out += hexDigits[bytes[i] & 15];
    }
    return out;
}

} // namespace ductus
