// The bundled sample clips of DoodleStudio, rendered by us and doodled on by program: each with its finished
// project.
#pragma once

#include "base/result.h"
#include "doodling/canvas/canvas.h"
#include "support/clip_scenes.h"

#include <filesystem>

namespace ductus {

struct SampleClip
{
    std::string id;     // of the files: id.mp4, id.ductus, id.png
    std::string title;  // what people read
    std::string lesson; // what can be learned, one line
    ClipScene scene;
    DoodleScene doodles; // in pixels of the scene's pictures
    int pictureFrame = 0;
};

/// A face rides on a box and passes behind a post; words on the wall, an arrow along the floor.
SampleClip passingBox();
/// Labels and stickers that stay where they are while the camera walks in.
SampleClip walkThrough();
/// A pendulum before a still camera; an arrow that is drawn anew as its speed changes.
SampleClip pendulum();
/// Chalk on the ground and on a wall, which keeps its perspective.
SampleClip chalkYard();
/// A ghost, drawn frame by frame, flies around shelves and behind them.
SampleClip ghostInTheStore();
/// A camera that only turns: birds, a sun and a label over hills.
SampleClip panOverHills();

std::vector<SampleClip> sampleClips();

/// ID.mp4, ID.ductus and ID.png for each, or those of \a ids alone, and clips.json with the titles of all.
Result<void> writeSampleClips(const std::filesystem::path &folder, const std::vector<std::string> &ids,
                              const JobControl &control);

} // namespace ductus
