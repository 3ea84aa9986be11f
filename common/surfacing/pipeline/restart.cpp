#include "surfacing/pipeline/restart.h"

#include "surfacing/pipeline/option_equality.h"
#include "surfacing/pipeline/preparation.h"

namespace ductus {

SurfacingStage restartFrom(const SurfaceOptions &a, const SurfaceOptions &b)
{
    if (a.resamplingStep != b.resamplingStep || a.symmetry != b.symmetry ||
        a.symmetryPlane.normal != b.symmetryPlane.normal ||
        a.symmetryPlane.offset != b.symmetryPlane.offset ||
        !sameOptions(a.symmetryDetection, b.symmetryDetection))
        return SurfacingStage::Sketch;
    if (!sameOptions(a.proxy, b.proxy))
        return SurfacingStage::Proxy;
    if (!sameOptions(a.association, b.association) || !sameOptions(a.trim, b.trim))
        return SurfacingStage::Association;
    if (!sameOptions(a.segmentation, b.segmentation))
        return SurfacingStage::Segmentation;
    return sameOptions(a.extraction, b.extraction) ? SurfacingStage::Nothing : SurfacingStage::Extraction;
}

Result<SurfacingState> resurface(const SurfacingState &before, const SurfacingRequest &request,
                                 bool sameInput, const std::function<void(const SurfacingState &)> &onPreview,
                                 const JobControl &control)
{
    const SurfacingStage stage = !sameInput || !before.isPrepared()
                                     ? SurfacingStage::Sketch
                                     : restartFrom(before.options, request.options);
    SurfacingState state = before;
    if (stage <= SurfacingStage::Proxy) {
        Result<SurfacingState> prepared =
            prepareSurfacing(request.strokes, request.givenProxy, request.options, control.part(0.0, 0.5));
        if (!prepared)
            return prepared;
        state = std::move(*prepared);
    } else if (stage == SurfacingStage::Association) {
        state.options.association = request.options.association;
        state.options.trim = request.options.trim;
        if (Result<void> done = prepareAssociation(state, control.part(0.0, 0.5)); !done)
            return done.error();
        state.labels = nullptr;
    }
    const bool sameLabels = stage > SurfacingStage::Segmentation && state.hasLabels() &&
                            state.labels->scribbles == request.scribbles;
    if (!sameLabels) {
        Result<SurfacingState> labelled =
            solveLabels(state, request.scribbles, request.options, control.part(0.5, 0.8));
        if (!labelled)
            return labelled;
        state = std::move(*labelled);
        if (onPreview)
            onPreview(state);
    }
    if (sameLabels && stage == SurfacingStage::Nothing && state.hasSurface())
        return state;
    return extractSurface(state, request.options, control.part(0.8, 1.0));
}

} // namespace ductus
