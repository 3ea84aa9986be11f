// Options of the local variational fit, apart from its machinery so that the pipeline's options can hold
// them.
#pragma once

#include "surfacing/proxy/local/patches.h"

#include <optional>

namespace ductus {

struct LocalFitOptions
{
    PatchOptions patches;
    std::optional<double> lambda; // smoothing as in fitVariational; chosen without it (smoothing_choice.h)
};

} // namespace ductus
