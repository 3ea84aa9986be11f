// The text of JSON values without interpreting them. What an app does not know it keeps as text, so
// that 1.50, a long integer or an escape come back byte for byte.
#pragma once

#include "base/result.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ductus {

/// Members of an object this program does not know: name and the text of the value, in file order.
using UnknownMembers = std::vector<std::pair<std::string, std::string>>;

/// One member as it stands in the text; both views without surrounding white space, the key with its quotes.
struct RawMember
{
    std::string_view key;
    std::string_view value;
};

/// Deepest nesting of arrays and objects; strings are skipped. Works on any bytes.
std::size_t jsonDepth(std::string_view text);

/// Members of the object \a text, which must be valid JSON (checked by a parser before). Empty for anything
/// else.
std::vector<RawMember> rawMembers(std::string_view text);

/// Elements of the array \a text, under the same condition.
std::vector<std::string_view> rawElements(std::string_view text);

} // namespace ductus
