// FrameMaker: pictures of one painting without a window, by OpenGL where there is any, else by the processor.
//
//     Result<std::unique_ptr<FrameMaker>> frames = makeFrames(painting, options);
//     Result<Image> picture = (*frames)->frame({seconds, look}, camera, control);
#pragma once

#include "imaging/image.h"
#include "painting/reference/frame_camera.h"
#include "painting/reference/painting_solid.h"

#include <memory>

namespace ductus {

struct FrameOptions
{
    int width = 1280; // pixels, 1..16384
    int height = 800;
    int samplesPerAxis = 2; // of each pixel, 1..8; a card may take fewer
    bool transparentBackground = false;
    bool exact = false; // by the processor: slow, the same bytes on every machine
};

class FrameMaker
{
public:
    virtual ~FrameMaker() = default;

    /// Straight sRGB and alpha, rows from the top. Errors of PaintingRenderer, referenceFrame(); Cancelled.
    virtual Result<Image> frame(const PaintingMoment &moment, const FrameCamera &camera,
                                const JobControl &control) = 0;
    /// True if a graphics card or driver draws.
    virtual bool usesGraphics() const = 0;
};

/// To be used and destroyed on the thread that made it. Where OpenGL 4.3 is missing, or the card refuses the
/// size, the processor draws.
std::unique_ptr<FrameMaker> makeFrames(std::shared_ptr<const Painting> painting, const FrameOptions &options);

} // namespace ductus
