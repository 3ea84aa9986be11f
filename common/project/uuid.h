// Uuid: the name of a project or document, the same wherever it is copied to (RFC 4122, version 4).
#pragma once

#include "base/random.h"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ductus {

struct Uuid
{
    std::array<std::uint8_t, 16> bytes = {};

    /// A new one, from the system's entropy.
    static Uuid create();
    /// A reproducible one, for tests and samples.
    static Uuid from(Random &random);
    /// Of the form 8-4-4-4-12, lower-case hex digits; nothing else.
    static std::optional<Uuid> parse(std::string_view text);

    bool isNull() const { return *this == Uuid(); }
    std::string text() const;
    auto operator<=>(const Uuid &) const = default;
};

} // namespace ductus
