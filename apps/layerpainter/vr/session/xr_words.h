// OpenXR's results as errors in words.
#pragma once

#include "base/result.h"

#include <openxr/openxr.h>

namespace ductus {

/// What \a result means for a painter, with what to do where that is known. \a attempted as in Error,
/// \a function: the call that failed, as the place.
Error xrError(const char *attempted, const char *function, XrResult result);

/// Nothing for results that are no failure.
Result<void> checkXr(const char *attempted, const char *function, XrResult result);

/// An OpenXR struct of that type, all else zero.
template <typename T>
T xrStruct(XrStructureType type)
{
    T value{};
    value.type = type;
    return value;
}

} // namespace ductus
