// JsonDocument: parsed JSON together with its text, from hostile bytes.
#pragma once

#include "base/result.h"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ductus {

struct JsonDocument
{
    std::string text;
    nlohmann::json value; // points into nothing; text and value say the same
};

/// Parses \a text (UTF-8, no comments, no byte order mark). \a place is the file and entry, for errors;
/// bounded in size and depth before parsing. Errors tell line and column.
Result<JsonDocument> parsedJson(std::string text, const std::string &place);

} // namespace ductus
