// The OpenTimelineIO file of `doodlestudio export --otio`.
#pragma once

#include "doodlestudio/cli/open_doodle.h"

namespace ductus {

/// Writes \a doodle's timeline to \a path; the clip (\a clip if it was moved, else as the project knows it)
/// is named as seen from there. Errors: those of writing.
Result<void> writeTimelineFile(const OpenedDoodle &doodle, const std::filesystem::path &clip,
                               const std::filesystem::path &path);

} // namespace ductus
