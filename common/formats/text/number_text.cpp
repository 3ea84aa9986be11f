#include "formats/text/number_text.h"

#include <charconv>
#include <cmath>

namespace ductus {

namespace {

std::string_view withoutPlus(std::string_view token)
{
    // from_chars does not know the '+' some exporters write; "+-1" stays an error.
    if (token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+')
        token.remove_prefix(1);
    return token;
}

/// from_chars says "out of range" for 1e-400 as for 1e400; only the former may be read as 0.
bool isTiny(std::string_view token)
{
    const std::size_t exponent = token.find_first_of("eE");
    if (exponent != std::string_view::npos)
        return exponent + 1 < token.size() && token[exponent + 1] == '-';
    const std::size_t firstDigit = token.find_first_of("123456789");
    return token.find('.') < firstDigit;
}

} // namespace

NumberFault readNumber(std::string_view token, double &value)
{
    token = withoutPlus(token);
    double parsed = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), parsed);
    if (error == std::errc::invalid_argument || end != token.data() + token.size())
        return token.find(',') != std::string_view::npos ? NumberFault::DecimalComma
                                                         : NumberFault::NotANumber;
    if (error == std::errc::result_out_of_range) {
        if (!isTiny(token))
            return NumberFault::TooLarge;
        parsed = 0.0;
    }
    if (!std::isfinite(parsed))
        return NumberFault::NotFinite;
    if (std::abs(parsed) > largestCoordinate)
        return NumberFault::TooLarge;
    value = parsed;
    return NumberFault::None;
}

NumberFault readInteger(std::string_view token, std::int64_t &value)
{
    token = withoutPlus(token);
    std::int64_t parsed = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), parsed);
    if (error == std::errc::invalid_argument || end != token.data() + token.size())
        return NumberFault::NotANumber;
    if (error == std::errc::result_out_of_range)
        return NumberFault::TooLarge;
    value = parsed;
    return NumberFault::None;
}

std::string describeFault(NumberFault fault, std::string_view token)
{
    switch (fault) {
    case NumberFault::None:
        break;
    case NumberFault::NotANumber:
        return inQuotes(token) + " is not a number";
    case NumberFault::DecimalComma:
        return inQuotes(token) + " has a comma";
    case NumberFault::NotFinite:
        return inQuotes(token) + " is not a finite number";
    case NumberFault::TooLarge:
        return inQuotes(token) + " is too large a number";
    }
    return inQuotes(token) + " is fine";
}

std::string remedyForFault(NumberFault fault)
{
    switch (fault) {
    case NumberFault::DecimalComma:
        return "Write numbers with a decimal point and put spaces between them (export with an English "
               "locale)";
    case NumberFault::NotFinite:
        return "Remove the broken point or export the file again";
    case NumberFault::TooLarge:
        return "Scale the model down or export the file again";
    case NumberFault::None:
    case NumberFault::NotANumber:
        break;
    }
    return "Correct this line or export the file again";
}

std::string inQuotes(std::string_view token)
{
    constexpr std::size_t longest = 40;
    std::string text = "'";
    for (char c : token.substr(0, longest))
        text += (c >= ' ' && c <= '~') ? c : '?';
    return text + (token.size() > longest ? "...'" : "'");
}

void appendNumber(std::string &text, double value)
{
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end);
}

void appendNumber(std::string &text, std::int64_t value)
{
    char digits[24];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end);
}

} // namespace ductus
