// Filmed things with a truth: the camel and the car of the DAVIS clips, cut out of one frame, walk, run, turn
// and hide before another clip that goes on behind them. Their looks, edges and backgrounds are those of real
// films, their motion is ours: limbs swing against each other, the exposure smears what is fast, the light
// changes.
#pragma once

#include "base/result.h"
#include "doodling/clip/clip.h"
#include "doodling/scene/shot_camera.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace ductus {

/// How a cut-out stands in a frame; frames may be fractions.
struct CutOutPose
{
    Vec2 middle = Vec2::Zero();    // pixels of the picture
    double turn = 0.0, size = 1.0; // radians; a factor
    double swing = 0.0, phase = 0; // of what is low on it: pixels of the cut-out, radians
};

struct CutOut
{
    Image picture; // alpha: how far it is the thing
    std::function<CutOutPose(double frame)> pose;
};

struct PhotoScene
{
    std::string name;
    int frameCount = 0;
    double exposure = 0.5; // frames
    std::shared_ptr<Clip> background;
    std::vector<CutOut> cutOuts; // the nearest last; the first one is followed
};

struct PhotoTrack
{
    std::vector<Vec2> pixels;
    std::vector<bool> isVisible;
};

/// Of points of the followed cut-out on a grid of \a spacing pixels in it.
std::vector<PhotoTrack> photoTracks(const PhotoScene &scene, double spacing);

std::unique_ptr<Clip> clipOf(const PhotoScene &scene);

/// FileNotFound where the clips are not there.
Result<std::vector<PhotoScene>> photoScenes(const std::filesystem::path &data);

} // namespace ductus
