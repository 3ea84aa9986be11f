#include "sketchsurfacer/document/sketch_content.h"

namespace ductus {

SurfacingRequest requestOf(const SketchContent &content)
{
    SurfacingRequest request;
    request.strokes = *content.strokes;
    if (content.givenProxy)
        request.givenProxy = *content.givenProxy;
    request.options = content.options;
    request.scribbles = content.scribbles;
    return request;
}

bool hasSameInput(const SketchContent &before, const SketchContent &after)
{
    return before.strokes == after.strokes && before.givenProxy == after.givenProxy &&
           before.reading == after.reading;
}

SurfaceOptions defaultSurfaceOptions()
{
    SurfaceOptions options;
    options.symmetry = SymmetryMode::Auto;
    return options;
}

} // namespace ductus
