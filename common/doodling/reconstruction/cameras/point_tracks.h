// Corners followed from frame to frame: what the cameras are solved from. Dense flow says roughly where a
// corner went, and Lucas-Kanade there and back where exactly.
#pragma once

#include "doodling/reconstruction/long_flow.h"
#include "doodling/scene/shot_camera.h"

#include <memory>

namespace ductus {

struct PointTrack
{
    int firstFrame = 0;
    std::vector<Vec2> pixels; // one a frame from the first on

    int endFrame() const { return firstFrame + int(pixels.size()); }
    bool isIn(int frame) const { return frame >= firstFrame && frame < endFrame(); }
    const Vec2 &at(int frame) const { return pixels[std::size_t(frame - firstFrame)]; }
};

struct PointTrackOptions
{
    double spacingShare = 0.025; // of the picture's width: between two tracks
    double quality = 0.003;      // of the strongest corner: weaker ones are left out
    double mostReturnMiss = 0.6; // pixels: there and back
    double mostFlowMiss = 4.0;   // pixels from where the dense flow leads
    int shortest = 4;            // frames: shorter tracks are dropped
};

/// Takes the frames one after the other and keeps two of them.
class PointTracker
{
public:
    explicit PointTracker(const PointTrackOptions &options = {});
    ~PointTracker();
    /// \a fromPrevious is the flow from the frame added before; null for the first one.
    void add(const Image &frame, const CompactFlow *fromPrevious);
    std::vector<PointTrack> takeTracks();

private:
    struct State;
    std::unique_ptr<State> mState;
};

} // namespace ductus
