// Lines drawn on a canvas for the other apps, and their strokes for a canvas.
#pragma once

#include "document/stroke_clipboard.h"
#include "doodling/canvas/canvas.h"

namespace ductus {

/// The lines of \a frame, y up; words, areas, stickers and pictures are no strokes.
CopiedStrokes copiedLines(const DoodleFrame &frame);

/// \a strokes as lines on a sheet of \a canvasSize: those of a sheet where they were, those of a space seen
/// from its front and as large as fits well. What has no width or colour gets \a width and \a colour.
std::vector<InkStroke> inkStrokes(const CopiedStrokes &strokes, const Vec2 &canvasSize, double width,
                                  const Rgba &colour);

/// \a doodle with all of \a lines on top of drawing \a index.
Result<Doodle> withLines(const Doodle &doodle, int index, const std::vector<InkStroke> &lines);

} // namespace ductus
