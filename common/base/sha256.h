// Content hashes: buffers and media are named by them, links and caches compare them.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace ductus {

class Sha256
{
public:
    Sha256();
    ~Sha256();
    void add(std::span<const std::byte> bytes);
    /// 64 lower-case hex digits; the object starts anew.
    std::string hexDigest();

private:
    struct State;
    std::unique_ptr<State> mState;
};

/// 64 lower-case hex digits.
std::string sha256Hex(std::span<const std::byte> bytes);

} // namespace ductus
