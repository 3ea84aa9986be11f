// A frame's motion, depth and moving cells as records of the cache. What does not fit together is no record.
#pragma once

#include "doodling/cache/record.h"
#include "doodling/reconstruction/depth_map.h"
#include "doodling/reconstruction/frame_motion.h"

namespace ductus {

RecordWriter recordOf(const FrameMotion &motion);
std::optional<FrameMotion> motionFrom(RecordReader &reader);

RecordWriter recordOf(const DepthMap &depth);
std::optional<DepthMap> depthFrom(RecordReader &reader);

} // namespace ductus
