// A clip's analysis with the cache: taken from there, gone on with, or made.
#pragma once

#include "doodling/reconstruction/shot.h"

namespace ductus {

struct AnalysedShot
{
    std::shared_ptr<const Shot> shot; // never null
    std::string digest;               // of the clip; empty if the cache was off
    AnalysisReport report;
    /// The cache could not be used, so that all is in memory and a project must hold it.
    std::optional<Error> cacheProblem;
};

/// \a known: a shot whose cameras are taken as they are, as those of a project are; null: they are found.
/// Errors: those of the clip.
Result<AnalysedShot> analysedShot(const std::filesystem::path &clip, AnalysisCache cache, const Shot *known,
                                  const JobControl &control);

/// The same for a clip that is open, at \a path. \a cameras: found elsewhere, as ShotOptions::givenCameras.
Result<AnalysedShot> analysedShot(Clip &clip, const std::filesystem::path &path, AnalysisCache cache,
                                  const Shot *known, const JobControl &control,
                                  std::vector<ShotCamera> cameras = {});

} // namespace ductus
