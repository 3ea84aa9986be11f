// A painting from whatever file a batch command was given.
#pragma once

#include "base/job_control.h"
#include "painting/scene/painting.h"

#include <filesystem>

namespace ductus {

/// The first painting of a .ductus project; other files are imported.
Result<Painting> openPainting(const std::filesystem::path &path, const JobControl &control);

} // namespace ductus
