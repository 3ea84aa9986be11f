// A project with a filmed scene, and its clip.
#pragma once

#include "doodling/clip/clip.h"
#include "doodling/storage/doodle_content.h"

#include <filesystem>

namespace ductus {

struct OpenedDoodle
{
    Project project;
    std::shared_ptr<const DoodleContent> content; // not null
    std::filesystem::path clip;                   // where it should be
};

/// Errors name \a path.
Result<OpenedDoodle> openDoodle(const std::filesystem::path &path);

/// The clip of \a doodle, or the one at \a instead if that is not empty: it was moved. Refused if it has
/// another number of frames or another size than the one that was drawn on.
Result<std::unique_ptr<Clip>> openItsClip(const OpenedDoodle &doodle, const std::filesystem::path &instead,
                                          const JobControl &control);

} // namespace ductus
