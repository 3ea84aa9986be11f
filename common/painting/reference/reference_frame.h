// The frame a painting must give: painting.md section 2, pixel by pixel on the processor. What every other
// renderer is tested against; slow, exact, the same on every machine.
#pragma once

#include "imaging/image.h"
#include "painting/reference/frame_camera.h"
#include "painting/reference/painting_solid.h"

namespace ductus {

struct ReferenceOptions
{
    int width = 640; // pixels, 1..16384
    int height = 480;
    int samplesPerAxis = 1; // of each pixel, on a regular grid, 1..8
    PaintingMoment moment;
    bool transparentBackground = false;
};

struct ReferenceFrame
{
    Image colour;                      // straight sRGB and alpha
    std::vector<float> depth;          // along the view axis, scene units; infinity where nothing is
    std::vector<std::int32_t> stack;   // StackId, -1 where nothing is
    std::vector<std::int32_t> element; // ElementId
};

/// Colours of translucent substrates, of the background and of the samples of a pixel are mixed in the
/// painting's blend space, alpha premultiplied. Depth and ids are those of the nearest surface at the sample
/// in the middle (of those, the lower right). Reference pictures are not drawn. InvalidArgument for sizes or
/// a camera out of range and for a look that is not there; Cancelled.
Result<ReferenceFrame> referenceFrame(const Painting &painting, const FrameCamera &camera,
                                      const ReferenceOptions &options, const JobControl &control);

/// The same of a painting that is ready: several views of one moment (options.moment is not looked at).
Result<ReferenceFrame> referenceFrame(const PaintingSolid &painting, const FrameCamera &camera,
                                      const ReferenceOptions &options, const JobControl &control);

} // namespace ductus
