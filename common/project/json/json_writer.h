// JSON text as people like to read and compare it: the outer levels one member a line, the inner ones on one
// line. Members are in the order they were set; unknown ones stand as the text they came with.
#pragma once

#include "project/json/raw_json.h"

#include <nlohmann/json.hpp>
#include <string>

namespace ductus {

using OrderedJson = nlohmann::ordered_json;

/// Appends members kept from reading to \a object, to be written as they were. Names \a object has are left
/// alone.
void addUnknown(OrderedJson &object, const UnknownMembers &unknown);

/// \a value as text; arrays and objects nested deeper than \a openLevels are written on one line. Doubles are
/// written with as many digits as they need to come back exactly; they must be finite and strings UTF-8.
std::string jsonText(const OrderedJson &value, int openLevels = 3);

} // namespace ductus
