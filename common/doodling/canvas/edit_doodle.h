// Edits of what is drawn, as functions from the old doodle to the new one. What cannot be done is refused
// with InvalidArgument and changes nothing.
#pragma once

#include "doodling/canvas/doodle.h"

#include "base/result.h"

namespace ductus {

/// \a mark goes on top of frame \a index. Refused without points, words or a picture, with numbers that are
/// not finite and sizes that are not positive.
Result<Doodle> withMark(const Doodle &doodle, int index, DoodleMark mark);
/// Refused if it is not in the frame.
Result<Doodle> withoutMark(const Doodle &doodle, int index, const MarkPointer &mark);
Result<Doodle> withChangedMark(const Doodle &doodle, int index, const MarkPointer &old, DoodleMark mark);

/// Takes away what of frame \a index lies within \a radius (canvas units) of the line \a path: lines are cut
/// and what is left of them stays, other marks go whole if their middle or outline is touched. Gives the same
/// frame back if nothing is.
Result<Doodle> withErased(const Doodle &doodle, int index, const std::vector<Vec2> &path, double radius);

/// An empty frame before the one at \a index (index = count: at the end), as long as \a hold.
Result<Doodle> withInsertedFrame(const Doodle &doodle, int index, int hold);
/// A copy behind it.
Result<Doodle> withDuplicatedFrame(const Doodle &doodle, int index);
/// Refused for the only one.
Result<Doodle> withoutFrame(const Doodle &doodle, int index);
Result<Doodle> withMovedFrame(const Doodle &doodle, int from, int to);
Result<Doodle> withHold(const Doodle &doodle, int index, int hold);

/// Every point of \a mark moved by \a shift, canvas units.
DoodleMark movedMark(const DoodleMark &mark, const Vec2 &shift);

/// The topmost mark of \a frame within \a reach (canvas units) of \a point; null if there is none.
MarkPointer markAt(const DoodleFrame &frame, const Vec2 &point, double reach);

} // namespace ductus
