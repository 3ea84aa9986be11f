// Where every place of a picture moves to in another one, and how far that is to be trusted.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "doodling/reconstruction/rough_match.h"
#include "imaging/image.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace ductus {

/// What a flow field says of a place.
struct MotionAt
{
    Eigen::Vector2d motion = Eigen::Vector2d::Zero(); // pixels of the picture
    double confidence = 0.0;                          // 0..1
};

/// The four cells around a place and their shares; places outside count as the border.
struct GridPlace
{
    std::size_t cells[4];
    double shares[4];

    GridPlace(const Eigen::Vector2d &pixel, double cellSize, int width, int height);
};

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
    MotionAt at(const Eigen::Vector2d &pixel) const;
};

struct FlowOptions
{
    int cellSize = 4; // pixels: a quarter of the numbers of every second pixel, and tracks as good
    // A step there and back that misses by so much is trusted half. Less than the published one pixel, which
    // only says yes or no.
    double halfTrust = 0.7;       // pixels,
    double halfTrustShare = 0.05; // plus this share of the motion: long ones are never as exact
    bool isFullSize = true;       // else of half the size: a third of the time, a fifth more error
};

/// Pixels that a motion of a given confidence misses by there and back: what the confidence was made of.
double missOf(const MotionAt &at, const FlowOptions &options = {});

struct FlowPair
{
    FlowField forward;  // from -> to
    FlowField backward; // to -> from
};

/// What of a picture flow is found from: made once a picture.
struct FlowPicture
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> grey;
    WindowPyramid windows;
};

FlowPicture flowPictureOf(const Image &image);

/// Dense inverse search [Kroeger 2016, OpenCV], started from the windows' rough motion wherever that fits
/// better, in both directions between two pictures of one size. Keeps its working memory from pair to pair;
/// one thread at a time may use it.
class FlowFinder
{
public:
    FlowFinder();
    ~FlowFinder();
    FlowFinder(FlowFinder &&) noexcept;

    FlowPair find(const FlowPicture &from, const FlowPicture &to, const FlowOptions &options = {});

private:
    struct State;
    std::unique_ptr<State> mState;
};

/// The same for a single pair.
FlowPair denseFlow(const FlowPicture &from, const FlowPicture &to, const FlowOptions &options = {});
FlowPair denseFlow(const Image &from, const Image &to, const FlowOptions &options = {});

} // namespace ductus
