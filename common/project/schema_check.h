// Checking JSON against the schemas in resources/schemas (JSON Schema draft 7), for validate and the tests.
// Opening a project does not need them: the reader checks every field itself and says more about it.
#pragma once

#include "base/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

/// The text of resources/schemas/<name>.schema.json, built in; empty for unknown names.
/// Names: "project", "sketch_surface", "painting", "doodle".
std::string_view schemaText(std::string_view name);

/// What contradicts the schema in \a jsonText, one line each ("/strokes/3: ..."); empty if all is well.
/// InvalidArgument for an unknown schema, Malformed if the text is not JSON.
Result<std::vector<std::string>> schemaViolations(std::string_view jsonText, std::string_view schemaName);

/// The same for project.json and all documents of a kind known here in a whole .ductus file; places start
/// with the entry.
Result<std::vector<std::string>> projectSchemaViolations(std::span<const std::byte> bytes,
                                                         const std::string &name);

} // namespace ductus
