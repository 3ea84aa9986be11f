// What is drawn on a canvas, painted with QPainter while it is being drawn; finished pictures are composited
// by the engine, from the same pieces.
#pragma once

#include "doodling/canvas/doodle.h"

#include <QPainter>

namespace ductus {

/// \a painter in canvas units times canvasGrain.
void paintMark(QPainter &painter, const DoodleMark &mark);
void paintMarks(QPainter &painter, const DoodleFrame &frame);

QColor toColour(const Rgba &colour);
Rgba toRgba(const QColor &colour);

} // namespace ductus
