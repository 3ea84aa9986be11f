// Depth maps from elsewhere made those of a shot: brought to its scale, holes filled, moving things known by
// the shot's own analysis.
#pragma once

#include "doodling/reconstruction/given/depth_folder.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// \a shot with the depth of \a files, one a frame. Their unit need not be known: one factor brings them to
/// what the shot measured (or guessed). Malformed for files without a usable number or of changing shape.
Result<Shot> withGivenDepth(const Shot &shot, const std::vector<std::filesystem::path> &files,
                            const JobControl &control);

/// On the shot's grid: disparities of 1 / unit of the file, with what is not known taken from around.
std::vector<float> gridDisparities(const GivenDepth &depth, const DepthMap &grid, int pictureWidth,
                                   int pictureHeight);

} // namespace ductus
