// A JSON text read as a stream, in which finished objects can be taken out and replaced by a number: a scene
// of 50 MB never stands in memory as JSON.
#pragma once

#include "base/job_control.h"
#include "formats/archive/byte_source.h"

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

namespace ductus {

struct ObjectStreamHooks
{
    /// Called for every object when it is complete, innermost first. May change or move from it. An Error
    /// ends the reading.
    std::function<std::optional<Error>(nlohmann::json &object)> objectComplete;
};

/// What a complete object is replaced by: no JSON text can contain it.
nlohmann::json takenOut(std::uint64_t number);
std::optional<std::uint64_t> takenOutNumber(const nlohmann::json &value);

/// The root of the text. Malformed with the line for invalid JSON (also nan and inf) and for text nested
/// deeper than 600.
Result<nlohmann::json> readObjectStream(ByteSource &text, const ObjectStreamHooks &hooks,
                                        const std::string &attempted, const JobControl &control);

} // namespace ductus
