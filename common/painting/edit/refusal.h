// What refused edits say.
#pragma once

#include "painting/scene/painting.h"
#include "painting/scene/painting_check.h"

namespace ductus {

inline Error refusal(std::string attempted, std::string problem, std::string remedy, std::string place = "",
                     ErrorCode code = ErrorCode::InvalidArgument)
{
    return {code, std::move(attempted), std::move(problem), std::move(remedy), std::move(place)};
}

inline Error noSuchLayer(std::string attempted)
{
    return refusal(std::move(attempted), "there is no such layer", "Choose a layer of this painting");
}

inline Error lockedLayer(std::string attempted, const Layer &layer)
{
    return refusal(std::move(attempted), "the layer is locked", "Unlock it first", layer.name,
                   ErrorCode::Locked);
}

/// The Error of a failed check in the words of the edit.
inline Error unsound(Error error, std::string attempted)
{
    error.attempted = std::move(attempted);
    error.remedy = "Give a value inside its range";
    return error;
}

} // namespace ductus
