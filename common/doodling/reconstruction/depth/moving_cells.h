// Which cells of every frame show what moves by itself: their flow is none that the camera makes.
#pragma once

#include "doodling/reconstruction/depth/edge_aware_smoothing.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// How far flow over a few frames is from what the camera alone would make of a still scene, pixels a cell,
/// with a trust of 0..1. Where the camera's place is unknown or still, only its turning is taken off; else
/// what lies across the epipolar line, or runs against it (motion along it looks like depth).
struct OwnMotion
{
    std::vector<float> pixels;
    std::vector<float> trusts;
};

OwnMotion ownMotion(const Shot &shot, int frame);

/// Likelihood 0..1 that a cell moves by itself, smoothed within what looks alike.
std::vector<float> movingLikelihood(const OwnMotion &motion, const EdgeWeights &edges, double width);

/// The likelihoods of all frames voted along the flow, both ways in time: what moved before or moves later
/// is known while it rests.
void voteAlongFlow(const Shot &shot, std::vector<std::vector<std::uint8_t>> &likelihoods);

/// Cells above one half in connected groups, numbered alike from frame to frame; groups too small to hold a
/// canvas are left out.
std::vector<std::vector<std::uint8_t>>
numberedObjects(const Shot &shot, const std::vector<std::vector<std::uint8_t>> &likelihoods);

} // namespace ductus
