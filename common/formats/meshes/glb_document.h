// Safe access to the JSON of a glTF file: nothing in it is trusted to exist, to be of the right type or in
// range.
#pragma once

#include "base/result.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

struct GlbDocument
{
    nlohmann::json root;     // an object
    std::string_view binary; // the BIN chunk; empty if there is none
    std::string name;        // of the file, for messages

    /// "scene.glb: accessors[3]".
    Error error(const std::string &where, const std::string &problem,
                ErrorCode code = ErrorCode::Malformed) const;

    /// Object \a index of the array \a list ("nodes"), or an Error.
    Result<const nlohmann::json *> item(const char *list, std::int64_t index) const;
};

/// Splits the container and parses the JSON. \a bytes must outlive the document.
Result<GlbDocument> openGlb(std::string_view bytes, const std::string &name);

/// A non-negative whole number; \a fallback if the key is absent; nothing if it is something else.
std::optional<std::int64_t> glbCount(const nlohmann::json &object, const char *key, std::int64_t fallback);

/// A string, or "" if absent or not one.
std::string glbText(const nlohmann::json &object, const char *key);

/// \a size finite numbers, or an empty vector if absent; nothing if it is something else.
std::optional<std::vector<double>> glbNumbers(const nlohmann::json &object, const char *key,
                                              std::size_t size);

/// Values of an accessor, \a components to each ("VEC3": 3, "SCALAR": 1). Normalised integers are scaled as
/// the standard says. Bounds are checked before anything is allocated.
Result<std::vector<double>> readGlbAccessor(const GlbDocument &document, std::int64_t index, const char *type,
                                            std::size_t components);

} // namespace ductus
