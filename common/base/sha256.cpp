#include "base/sha256.h"

#include <array>
#include <nettle/sha2.h>

namespace ductus {

struct Sha256::State
{
    sha256_ctx context;
};

Sha256::Sha256() : mState(std::make_unique<State>())
{
    sha256_init(&mState->context);
}

Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::byte> bytes)
{
    sha256_update(&mState->context, bytes.size(), reinterpret_cast<const std::uint8_t *>(bytes.data()));
}

std::string Sha256::hexDigest()
{
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
    sha256_digest(&mState->context, digest.size(), digest.data());
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (std::uint8_t byte : digest) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

std::string sha256Hex(std::span<const std::byte> bytes)
{
    Sha256 hash;
    hash.add(bytes);
    return hash.hexDigest();
}

} // namespace ductus
