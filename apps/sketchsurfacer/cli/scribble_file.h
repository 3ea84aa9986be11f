// Scribble files: what a designer would draw over the result, as JSON
// (resources/schemas/scribbles.schema.json):
//
//     {"schema": "scribbles", "version": 1, "scribbles": [
//         {"kind": "merge", "points": [[0.1, 0.2, 0.3], [0.4, 0.2, 0.3]]},
//         {"kind": "set-degree", "points": [[0, 0.5, 0]], "options": {"degree": 1}}]}
#pragma once

#include "base/result.h"
#include "surfacing/refinement/scribble.h"

#include <filesystem>
#include <string>

namespace ductus {

/// Points stand in the coordinates of the sketch. Errors tell file and place
/// ("s.json#/scribbles/3/points/0").
Result<std::vector<Scribble>> readScribbles(const std::filesystem::path &path);

/// The same from memory; \a name stands for the file in messages.
Result<std::vector<Scribble>> parseScribbles(std::string text, const std::string &name);

} // namespace ductus
