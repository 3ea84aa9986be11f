// Numbers from and to text, always with a decimal point whatever the user's locale.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ductus {

/// Coordinates beyond this are refused: their squares and products must stay finite everywhere in the engine.
constexpr double largestCoordinate = 1e30;

enum class NumberFault { None, NotANumber, DecimalComma, NotFinite, TooLarge };

/// Reads the whole \a token as a finite number of magnitude <= largestCoordinate. A leading '+' is fine;
/// numbers too small for a double become 0. \a value is untouched on a fault.
NumberFault readNumber(std::string_view token, double &value);

/// Reads the whole \a token as a decimal integer.
NumberFault readInteger(std::string_view token, std::int64_t &value);

/// "'0,5' has a decimal comma": what is wrong with \a token, for Error::problem.
std::string describeFault(NumberFault fault, std::string_view token);

/// What to do about it, for Error::remedy.
std::string remedyForFault(NumberFault fault);

/// \a token in quotes, shortened and without control characters, fit for a message.
std::string inQuotes(std::string_view token);

/// Appends the shortest text that reads back as the same number.
void appendNumber(std::string &text, double value);
void appendNumber(std::string &text, std::int64_t value);

} // namespace ductus
