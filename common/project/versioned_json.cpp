#include "project/versioned_json.h"

#include "project/json/json_reader.h"

namespace ductus {

Result<VersionedJson> parsedVersionedJson(std::string text, const std::string &schema, int currentVersion,
                                          const MigrationTable &migrations, const std::string &place)
{
    Result<JsonDocument> parsed = parsedJson(std::move(text), place);
    if (!parsed)
        return parsed.error();
    VersionedJson result{std::move(*parsed)};
    const JsonReader reader(result.json, place);
    reader.expectObject();
    if (const std::string found = reader.string("schema", 64); found != schema)
        reader.failAt("schema", "\"" + schema + "\" is expected here, not \"" + found + "\"");
    constexpr int highest = 1'000'000;
    result.fileVersion = int(reader.integer("version", 0, highest));
    // Without a promise only programs of the same version may read it.
    const auto minReader =
        reader.has("minReader") ? int(reader.integer("minReader", 0, highest)) : result.fileVersion;
    if (reader.failed())
        return reader.error();
    if (result.fileVersion > currentVersion) {
        result.isNewer = true;
        result.neededVersion = minReader > currentVersion ? minReader : 0;
        return result;
    }
    if (result.fileVersion < currentVersion) {
        OrderedJson object = OrderedJson::parse(result.json.text);
        if (Result<void> done = migrations.migrate(object, schema, result.fileVersion, currentVersion, place);
            !done)
            return done.error();
        Result<JsonDocument> upgraded = parsedJson(jsonText(object, 0), place);
        if (!upgraded)
            return upgraded.error();
        result.json = std::move(*upgraded);
    }
    return result;
}

} // namespace ductus
