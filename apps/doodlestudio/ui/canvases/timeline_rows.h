// The canvases of a scene as rows of the timeline, and the timeline's wishes as edits.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"
#include "doodlestudio/ui/timeline/timeline_row.h"
#include "doodling/canvas/edit_scene.h"

namespace ductus {

/// The topmost canvas first.
QList<TimelineRow> timelineRows(const StudioState &state);

KeyframeKind keyframeKind(TimelineMarkKind kind);

} // namespace ductus
