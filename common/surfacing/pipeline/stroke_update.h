// Incremental update: strokes were added, removed or moved, and only what they touch is solved again (thesis
// Sec. III.9 and Fig. III.17, where one stroke more meant a whole new run). Frame and proxy stay; the proxy
// is pulled to strokes that run beside it; strokes are associated anew; regions start from those before.
#pragma once

#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

struct StrokeUpdateOptions
{
    double attractFrom = 0.012; // a proxy further than this from an added stroke is pulled to it
    double largestChange = 0.5; // share of stroke length; with more a new proxy is worth its time
    double largestGrowth = 0.1; // of the sketch's box diagonal; the unit frame would no longer fit
};

struct StrokeUpdate
{
    std::optional<SurfacingState> state; // labels up to date; preview and surface are those of before
    bool isSolved = false;               // state has all of before: no stroke moved what was solved
    std::string refusal;                 // where there is no state: why all must be surfaced anew, a clause
};

/// \a before, which must have labels, with other \a strokes (as read) and the same options and proxy. Added
/// strokes must lie within options.association.maxDistance of the proxy. The answer depends on \a before as
/// well as on the strokes.
Result<StrokeUpdate> updateStrokes(const SurfacingState &before, const StrokeSet &strokes,
                                   const StrokeUpdateOptions &options, const JobControl &control);

} // namespace ductus
