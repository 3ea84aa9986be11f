// How far a reconstruction is from the truth, after the one scale and place that no film tells.
#pragma once

#include "doodling/reconstruction/shot.h"

#include <optional>
#include <string>

namespace ductus {

/// What is measured of one clip.
struct ReconstructionScores
{
    std::string rung;                  // "solved", "rotation", "tripod"
    std::optional<double> pathShare;   // root mean square error of the camera's places, of the path's length
    std::optional<double> worstTurn;   // degrees, against the first frame
    std::optional<double> medianDepth; // relative error of what stands still, after one scale
    std::optional<double> movingOverlap; // intersection over union of what moves by itself
};

/// Depth samples: found and true ones, in pairs.
struct DepthPair
{
    double found = 0.0, real = 0.0;
};

std::string rungName(CameraKnowledge knowledge);
/// Nothing for paths without length.
std::optional<double> pathErrorShare(const std::vector<ShotCamera> &found,
                                     const std::vector<ShotCamera> &real);
double worstTurnDegrees(const std::vector<ShotCamera> &found, const std::vector<ShotCamera> &real);
/// Nothing without pairs.
std::optional<double> medianDepthError(const std::vector<DepthPair> &pairs);

} // namespace ductus
