#include "surfacing/pipeline/surface_pipeline.h"

#include "surfacing/pipeline/stopwatch.h"
#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

Result<SurfaceResult> surfaceSketch(const StrokeSet &strokes, const std::optional<TriangleMesh> &givenProxy,
                                    const SurfaceOptions &options, const JobControl &control)
{
    Stopwatch total;
    const Result<SurfacingState> prepared =
        prepareSurfacing(strokes, givenProxy, options, control.part(0.0, 0.5));
    if (!prepared)
        return prepared.error();
    const Result<SurfacingState> labelled = solveLabels(*prepared, {}, options, control.part(0.5, 0.8));
    if (!labelled)
        return labelled.error();
    const Result<SurfacingState> finished = extractSurface(*labelled, options, control.part(0.8, 1.0));
    if (!finished)
        return finished.error();
    SurfaceResult result = *finished->surface;
    result.timings.total = total.lap();
    return result;
}

} // namespace ductus
