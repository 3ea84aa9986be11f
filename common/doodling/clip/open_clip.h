// The two kinds of clips, behind openClip.
#pragma once

#include "doodling/clip/clip.h"

namespace ductus {

Result<std::unique_ptr<Clip>> openVideo(const std::filesystem::path &path, const JobControl &control);
Result<std::unique_ptr<Clip>> openPictureFolder(const std::filesystem::path &path, const JobControl &control);

/// A folder of pictures is made of such files.
bool isPictureFile(const std::filesystem::path &path);
/// frame9 before frame10.
bool isBeforeInNameOrder(const std::filesystem::path &left, const std::filesystem::path &right);

} // namespace ductus
