// Where a mark is on its canvas.
#pragma once

#include "doodling/canvas/doodle.h"

namespace ductus {

/// The way from \a point to the nearest place of a polyline; of one point for one point; large for none.
double distanceToLine(const Vec2 &point, const std::vector<Vec2> &line);

/// How far \a point is from what \a mark covers, canvas units: 0 on it. Words, stickers and pictures cover
/// their box (words about: a letter is taken for 0.55 of the line's height).
double distanceToMark(const Vec2 &point, const DoodleMark &mark);

/// The points of a line on the canvas.
std::vector<Vec2> flatPoints(const Stroke &line);

} // namespace ductus
