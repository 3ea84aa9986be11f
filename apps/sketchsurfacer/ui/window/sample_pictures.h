// Pictures of the bundled samples for the start page: drawn once by the software renderer and kept in the
// cache.
#pragma once

#include "document/jobs/job_runner.h"
#include "sketchsurfacer/document/sketch_import.h"

#include <functional>

namespace ductus {

/// Where the picture of \a sample is or will be.
QString samplePicturePath(const SampleSketch &sample, bool dark);

/// Draws those that are not there yet, quietly; \a drawn is called when they have come, unless \a receiver is
/// gone.
void drawSamplePictures(JobRunner &runner, const std::vector<SampleSketch> &samples, bool dark,
                        QObject *receiver, std::function<void()> drawn);

} // namespace ductus
