// Names of places in a painting's JSON, for UnknownPaintingMembers.
#pragma once

#include "base/sha256.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ductus {

/// "layer:5"
inline std::string idPlace(const char *kind, std::int32_t id)
{
    return std::string(kind) + ":" + std::to_string(id);
}

/// "layer:5/key:0of3": forgotten when the list gets another length.
inline std::string listPlace(const std::string &owner, const char *kind, std::size_t index, std::size_t count)
{
    return owner + "/" + kind + ":" + std::to_string(index) + "of" + std::to_string(count);
}

/// "layer:5/drawing@1f00...": forgotten when the elements are others.
inline std::string columnPlace(const std::string &owner, const std::vector<std::int32_t> &ids)
{
    return owner + "/drawing@" + sha256Hex(std::as_bytes(std::span(ids)));
}

} // namespace ductus
