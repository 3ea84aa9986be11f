// The common beginning of every object in a project: {"schema", "version", "minReader"}. Old versions are
// upgraded here, newer ones let through or refused.
#pragma once

#include "project/json/json_document.h"
#include "project/migrations/migration_table.h"

namespace ductus {

struct VersionedJson
{
    JsonDocument json;     // of the current version, or newer
    bool isNewer = false;  // but readable: everything this version knows means what it meant
    int neededVersion = 0; // greater than zero: must not be read by this version
    int fileVersion = 0;
};

/// Parses \a text as an object of \a schema. Malformed if schema or version are missing or other ones.
Result<VersionedJson> parsedVersionedJson(std::string text, const std::string &schema, int currentVersion,
                                          const MigrationTable &migrations, const std::string &place);

} // namespace ductus
