// The two kinds of clips, behind openClip.
#pragma once

#include "doodling/clip/clip.h"

namespace ductus {

Result<std::unique_ptr<Clip>> openVideo(const std::filesystem::path &path, const JobControl &control);
Result<std::unique_ptr<Clip>> openPictureFolder(const std::filesystem::path &path, const JobControl &control);

} // namespace ductus
