// A doodled shot as an OpenTimelineIO timeline, for editing programs: the clip on one track, each canvas as a
// clip on a track above it where it is shown, its keyframes and drawings as markers.
#pragma once

#include "doodling/storage/doodle_content.h"

namespace ductus {

/// OpenTimelineIO JSON (Timeline.1 with Clip.1, Gap.1, Marker.2), UTF-8, ends with a line's end. Times are
/// frames at the clip's rate. \a clipUrl: where the film is, as editing programs should look for it. What
/// OpenTimelineIO has no word for stands in metadata "ductus": places in pixels of the clip, depth, size,
/// turn as quaternion [x, y, z, w] of worldFromCanvas.
std::string timelineText(const std::string &name, const std::string &clipUrl, const ClipReference &clip,
                         const Shot &shot, const DoodleScene &scene);

} // namespace ductus
