#include "surfacing/pipeline/restart.h"

#include "surfacing/pipeline/option_equality.h"
#include "surfacing/pipeline/preparation.h"
#include "surfacing/pipeline/stroke_update.h"

namespace ductus {

namespace {

bool isSameProxy(const std::shared_ptr<const TriangleMesh> &before, const std::optional<TriangleMesh> &now)
{
    if (!before || !now)
        return !before && !now;
    return before->vertices == now->vertices && before->triangles == now->triangles;
}

void warn(SurfacingState &state, std::string text)
{
    auto sketch = std::make_shared<PreparedSketch>(*state.sketch);
    sketch->warnings.push_back(std::move(text));
    state.sketch = std::move(sketch);
}

} // namespace

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
    return sameOptions(a.extraction, b.extraction) && sameOptions(a.skeletal, b.skeletal)
               ? SurfacingStage::Nothing
               : SurfacingStage::Extraction;
}

Result<SurfacingState> resurface(const SurfacingState &before, const SurfacingRequest &request,
                                 bool sameInput, const std::function<void(const SurfacingState &)> &onPreview,
                                 const JobControl &control)
{
    SurfacingStage stage =
        before.isPrepared() ? restartFrom(before.options, request.options) : SurfacingStage::Sketch;
    SurfacingState state = before;
    StrokeUpdate update;
    if (!sameInput) {
        if (stage > SurfacingStage::Segmentation && before.hasLabels() &&
            isSameProxy(before.givenProxy, request.givenProxy)) {
            Result<StrokeUpdate> updated = updateStrokes(before, request.strokes, {}, control.part(0.0, 0.5));
            if (!updated)
                return updated.error();
            update = std::move(*updated);
        }
        if (update.state)
            state = *update.state;
        else
            stage = SurfacingStage::Sketch;
    }
    if (stage <= SurfacingStage::Proxy) {
        Result<SurfacingState> prepared =
            prepareSurfacing(request.strokes, request.givenProxy, request.options, control.part(0.0, 0.5));
        if (!prepared)
            return prepared;
        state = std::move(*prepared);
        if (!update.refusal.empty())
            warn(state, "The whole sketch was surfaced anew: " + update.refusal + ".");
    } else if (stage == SurfacingStage::Association) {
        state.options.association = request.options.association;
        state.options.trim = request.options.trim;
        if (Result<void> done = prepareAssociation(state, control.part(0.0, 0.5)); !done)
            return done.error();
        state.labels = nullptr;
    }
    const bool sameLabels = (!update.state || update.isSolved) && stage > SurfacingStage::Segmentation && state.hasLabels() &&
                            state.labels->scribbles == request.scribbles;
    if (!sameLabels) {
        Result<SurfacingState> labelled =
            solveLabels(state, request.scribbles, request.options, control.part(0.5, 0.8));
        if (!labelled)
            return labelled;
        state = std::move(*labelled);
        if (update.state) {
            state.timings.segmentation += update.state->timings.segmentation;
            state.timings.total += update.state->timings.segmentation;
        }
        if (onPreview)
            onPreview(state);
    }
    if (sameLabels && stage == SurfacingStage::Nothing && state.hasSurface())
        return state;
    return extractSurface(state, request.options, control.part(0.8, 1.0));
}

} // namespace ductus
