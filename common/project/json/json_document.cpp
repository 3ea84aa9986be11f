#include "project/json/json_document.h"

#include "project/container/limits.h"
#include "project/json/raw_json.h"

#include <algorithm>
#include <new>

namespace ductus {

namespace {

Error parseError(ErrorCode code, std::string problem, std::string place)
{
    return {code, "Reading the project", std::move(problem), "", std::move(place)};
}

std::string lineAndColumn(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t lineBegin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return std::to_string(line) + ":" + std::to_string(before.size() - lineBegin + 1);
}

} // namespace

Result<JsonDocument> parsedJson(std::string text, const std::string &place)
try {
    const ContainerLimits limits;
    if (text.size() > limits.maxJsonBytes)
        return parseError(ErrorCode::TooLarge, "the JSON text is too large", place);
    if (jsonDepth(text) > limits.maxJsonDepth)
        return parseError(ErrorCode::Malformed, "the JSON text is nested too deeply", place);
    try {
        nlohmann::json value = nlohmann::json::parse(text);
        return JsonDocument{std::move(text), std::move(value)};
    } catch (const nlohmann::json::parse_error &error) {
        return parseError(ErrorCode::Malformed, "this is not valid JSON",
                          place + ":" + lineAndColumn(text, error.byte));
    } catch (const nlohmann::json::exception &error) { // a number beyond the range of a double
        return parseError(ErrorCode::Malformed, std::string("this is not valid JSON: ") + error.what(),
                          place);
    }
} catch (const std::bad_alloc &) {
    return parseError(ErrorCode::TooLarge, "there is not enough memory", place);
}

} // namespace ductus
