#include "project/schema_check.h"

#include "project/container/container_reader.h"
#include "project/json/json_document.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <exception>

namespace ductus {

namespace {

using valijson::adapters::NlohmannJsonAdapter;

Error checkError(ErrorCode code, std::string problem, std::string place)
{
    return {code, "Checking the project", std::move(problem), "", std::move(place)};
}

std::string pointerOf(const std::vector<std::string> &context)
{
    std::string pointer;
    for (const std::string &part : context) { // "<root>", "[strokes]", "[3]"
        if (part.starts_with("["))
            pointer += "/" + part.substr(1, part.size() - 2);
    }
    return pointer.empty() ? "/" : pointer;
}

Result<std::vector<std::string>> violations(const nlohmann::json &value, std::string_view schemaName)
try {
    const std::string_view text = schemaText(schemaName);
    if (text.empty())
        return checkError(ErrorCode::InvalidArgument, "there is no schema " + std::string(schemaName), "");
    const nlohmann::json schemaJson = nlohmann::json::parse(text);
    valijson::Schema schema;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(NlohmannJsonAdapter(schemaJson), schema);
    valijson::Validator validator;
    valijson::ValidationResults results;
    std::vector<std::string> lines;
    if (validator.validate(schema, NlohmannJsonAdapter(value), &results))
        return lines;
    valijson::ValidationResults::Error error;
    while (results.popError(error))
        lines.push_back(pointerOf(error.context) + ": " + error.description);
    return lines;
} catch (const std::exception &error) {
    return checkError(ErrorCode::InvalidArgument, error.what(), std::string(schemaName));
}

} // namespace

Result<std::vector<std::string>> schemaViolations(std::string_view jsonText, std::string_view schemaName)
{
    const Result<JsonDocument> json = parsedJson(std::string(jsonText), std::string(schemaName));
    if (!json)
        return json.error();
    return violations(json->value, schemaName);
}

Result<std::vector<std::string>> projectSchemaViolations(std::span<const std::byte> bytes,
                                                         const std::string &name)
{
    const Result<Container> container = readContainer(bytes, name);
    if (!container)
        return container.error();
    std::vector<std::string> lines;
    const auto check = [&](const std::string &entryName,
                           const std::string &schema) -> Result<nlohmann::json> {
        const std::string place = name + ":" + entryName;
        const StoredEntry *entry = container->find(entryName);
        if (!entry)
            return checkError(ErrorCode::Malformed, "the entry is missing", place);
        const Result<Bytes> content = unpacked(*entry, place);
        if (!content)
            return content.error();
        Result<JsonDocument> json =
            parsedJson(std::string(reinterpret_cast<const char *>(content->data()), content->size()), place);
        if (!json)
            return json.error();
        const Result<std::vector<std::string>> found = violations(json->value, schema);
        if (!found)
            return found.error();
        for (const std::string &line : *found)
            lines.push_back(entryName + "#" + line);
        return std::move(json->value);
    };
    const Result<nlohmann::json> project = check("project.json", "project");
    if (!project)
        return project.error();
    if (!lines.empty()) // then its list of documents may be anything
        return lines;
    for (const nlohmann::json &record : (*project)["documents"]) {
        std::string schema = record["kind"];
        std::ranges::replace(schema, '-', '_');
        if (schema == "project" || schemaText(schema).empty())
            continue;
        if (Result<nlohmann::json> document = check(record["entry"], schema); !document)
            return document.error();
    }
    return lines;
}

} // namespace ductus
