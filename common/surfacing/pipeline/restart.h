// Which stage an edit reaches back to, and the re-run from there.
#pragma once

#include "surfacing/pipeline/surfacing_state.h"

#include <functional>

namespace ductus {

enum class SurfacingStage { Sketch, Proxy, Association, Segmentation, Extraction, Nothing };

/// The first stage that takes an option in which the two differ; Nothing where they are equal.
SurfacingStage restartFrom(const SurfaceOptions &before, const SurfaceOptions &after);

/// Everything a document asks for.
struct SurfacingRequest
{
    StrokeSet strokes;
    std::optional<TriangleMesh> givenProxy; // input coordinates
    SurfaceOptions options;
    std::vector<Scribble> scribbles;
};

/// \a request surfaced, from the first stage that differs from what \a before was made with. \a sameInput:
/// strokes and given proxy are those of \a before. If they are not, and \a before has labels made with the
/// same sketch, proxy and association options, only what the changed strokes touch is solved again
/// (stroke_update.h); where that cannot be, all is surfaced anew and a warning says why. Pass an empty \a
/// before for a fresh run. \a onPreview (may be empty) gets the state with labels while the final mesh is
/// still being made; it is called from the thread of the job.
Result<SurfacingState> resurface(const SurfacingState &before, const SurfacingRequest &request,
                                 bool sameInput, const std::function<void(const SurfacingState &)> &onPreview,
                                 const JobControl &control);

} // namespace ductus
