// The shot of an opened project with its motion and depth, wherever they are.
#pragma once

#include "doodlestudio/cli/open_doodle.h"
#include "doodling/reconstruction/analysed_shot.h"

namespace ductus {

/// From the project, from the cache, or found again from the clip at \a clip, which is then said on stderr.
Result<std::shared_ptr<const Shot>> wholeShot(const OpenedDoodle &doodle, const std::filesystem::path &clip,
                                              const JobControl &control);

/// From the project or the cache; else the project's cameras alone.
std::shared_ptr<const Shot> availableShot(const OpenedDoodle &doodle, const JobControl &control);

/// What people should know of an analysis, on stderr: a damaged or unusable cache.
void tellOf(const AnalysedShot &analysed);

} // namespace ductus
