// The small picture of any project, for file managers.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "imaging/image.h"

#include <filesystem>

namespace ductus {

/// The picture \a project was saved with, scaled down to \a longerSide pixels where it is larger. Where it
/// was saved without one (by a batch command), the app it belongs to is asked to draw it. Fails with
/// FileNotFound and Malformed for what is no project, Unsupported where nobody can draw it, Cancelled.
Result<Image> thumbnailOf(const std::filesystem::path &project, int longerSide, const JobControl &control);

} // namespace ductus
