// Where every place of a picture moves to in another one, and how far that is to be trusted.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "imaging/image.h"

#include <Eigen/Core>
#include <vector>

namespace ductus {

/// A grid over the picture: cell (x, y) has its middle at ((x + 0.5) * cellSize, (y + 0.5) * cellSize).
struct FlowField
{
    int width = 0, height = 0;            // cells
    double cellSize = 1.0;                // pixels of the picture
    std::vector<Eigen::Vector2f> motions; // pixels of the picture, row by row
    std::vector<float> confidences;       // 0..1: how well there and back agree; row by row

    /// Between cells by their four neighbours; places outside count as the border. Pixels of the picture.
    Eigen::Vector2d motionAt(const Eigen::Vector2d &pixel) const;
    double confidenceAt(const Eigen::Vector2d &pixel) const;
};

struct FlowOptions
{
    int cellSize = 4; // pixels: a quarter of the numbers of every second pixel, and tracks as good
    // A step there and back that misses by so much is trusted half. Less than the published one pixel, which
    // only says yes or no.
    double halfTrust = 0.7;       // pixels,
    double halfTrustShare = 0.05; // plus this share of the motion: long ones are never as exact
};

/// Dense inverse search [Kroeger 2016, OpenCV] in both directions between two pictures of one size.
struct FlowPair
{
    FlowField forward;  // from -> to
    FlowField backward; // to -> from
};

FlowPair denseFlow(const Image &from, const Image &to, const FlowOptions &options = {});

} // namespace ductus
