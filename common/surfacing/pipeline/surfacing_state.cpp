#include "surfacing/pipeline/surfacing_state.h"

#include "surfacing/extraction/half_mesh.h"
#include "surfacing/pipeline/finish_surface.h"
#include "surfacing/pipeline/option_equality.h"
#include "surfacing/pipeline/preparation.h"
#include "surfacing/pipeline/stopwatch.h"
#include "surfacing/pipeline/tubes.h"
#include "surfacing/refinement/refinement.h"

namespace ductus {

namespace {

double sumOf(const SurfaceTimings &t)
{
    return t.proxy + t.association + t.segmentation + t.extraction;
}

std::vector<char> planeVertices(const TriangleMesh &mesh, const std::optional<SymmetryPlane> &plane)
{
    return plane ? verticesInPlane(mesh, *plane) : std::vector<char>();
}

LabelPreview previewOf(const SurfacingState &state)
{
    const PreparedSketch &sketch = *state.sketch;
    const LabelSolution &labels = *state.labels;
    const SeamedMesh &seamed = *state.seamed;
    const std::vector<char> inPlane = planeVertices(seamed.mesh, sketch.plane);

    LabelPreview preview;
    std::vector<int> labelOfRegion;
    preview.triangleRegions = wholeRegions(seamed, sketch.plane.has_value(), inPlane,
                                           int(labels.segmentation.models.size()), &labelOfRegion);
    preview.mesh = inInputFrame(
        sketch.plane ? withMirrorImage(seamed.mesh, *sketch.plane, inPlane).mesh : seamed.mesh, sketch.frame);
    preview.regions.resize(labelOfRegion.size());
    std::vector<char> labelIsLocked(labels.segmentation.models.size(), 0);
    for (std::size_t v = 0; v < labels.vertexIsLocked.size(); ++v)
        if (labels.vertexIsLocked[v])
            labelIsLocked[std::size_t(labels.segmentation.labels[v])] = 1;
    for (std::size_t r = 0; r < labelOfRegion.size(); ++r) {
        const std::size_t label = std::size_t(labelOfRegion[r]);
        const bool isImage = r >= labels.segmentation.models.size();
        preview.regions[r].degree = labels.segmentation.models[label].degree;
        // Ids of mirror images: the other even or odd half of the numbers.
        preview.regionIds.push_back(2 * labels.modelIds[label] + (isImage ? 1 : 0));
        preview.regionIsLocked.push_back(labelIsLocked[label]);
    }
    for (std::size_t t = 0; t < preview.mesh.triangles.size(); ++t)
        preview.regions[std::size_t(preview.triangleRegions[t])].area +=
            0.5 * preview.mesh.areaVector(int(t)).norm();
    appendTubes(sketch, state.options.skeletal, preview);
    return preview;
}

} // namespace

PreparedProxy::PreparedProxy(Proxy made, StrokeSet bordered)
    : proxy(std::move(made)), topology(proxy.mesh), nearest(proxy.mesh), borderStrokes(std::move(bordered))
{
}

Result<SurfacingState> prepareSurfacing(const StrokeSet &strokes,
                                        const std::optional<TriangleMesh> &givenProxy,
                                        const SurfaceOptions &options, const JobControl &control)
{
    SurfacingState state;
    state.options = options;
    if (Result<void> read = prepareSketch(state, strokes); !read)
        return read.error();
    if (Result<void> made = prepareProxy(state, givenProxy, control.part(0.0, 0.9)); !made)
        return made.error();
    if (Result<void> associated = prepareAssociation(state, control.part(0.9, 1.0)); !associated)
        return associated.error();
    state.timings.total = sumOf(state.timings);
    return state;
}

Result<SurfacingState> solveLabels(const SurfacingState &prepared, const std::vector<Scribble> &scribbles,
                                   const SurfaceOptions &options, const JobControl &control)
{
    Stopwatch watch;
    SurfacingState state = prepared;
    const bool sameAsBefore = sameOptions(prepared.options.segmentation, options.segmentation);
    state.options.segmentation = options.segmentation;
    if (!sameAsBefore)
        state.labels = nullptr;
    const ScribbleDomain domain{state.proxy->proxy.mesh, state.proxy->topology, state.proxy->nearest,
                                *state.association,      state.sketch->frame,   state.sketch->plane};
    Result<std::shared_ptr<const LabelSolution>> labels =
        refine(domain, state.labels, scribbles, options.segmentation, control);
    if (!labels)
        return labels.error();
    state.labels = *labels;
    state.seamed = std::make_shared<const SeamedMesh>(
        insertSeams(state.proxy->proxy.mesh, state.proxy->topology, state.labels->segmentation.labels,
                    strokeCutPositions(state.proxy->proxy.mesh, state.proxy->topology, *state.association)));
    state.preview = std::make_shared<const LabelPreview>(previewOf(state));
    state.optimized = nullptr;
    state.surface = nullptr;
    state.timings.segmentation = watch.lap();
    state.timings.extraction = 0.0;
    state.timings.total = sumOf(state.timings);
    return state;
}

Result<SurfacingState> extractSurface(const SurfacingState &labelled, const SurfaceOptions &options,
                                      const JobControl &control)
{
    Stopwatch watch;
    SurfacingState state = labelled;
    state.options.extraction = options.extraction;
    state.options.skeletal = options.skeletal;
    const PreparedSketch &sketch = *state.sketch;
    const SeamedMesh &seamed = *state.seamed;
    const std::vector<char> inPlane = planeVertices(seamed.mesh, sketch.plane);
    Result<OptimizedMesh> optimized =
        optimizeMesh(seamed, state.labels->segmentation.models,
                     borderTargets(seamed.mesh, state.proxy->borderStrokes, inPlane), sketch.plane, inPlane,
                     options.extraction, control);
    if (!optimized)
        return optimized.error();
    state.optimized = std::make_shared<const OptimizedMesh>(std::move(*optimized));
    state.timings.extraction = watch.lap();
    state.timings.total = sumOf(state.timings);

    auto result = std::make_shared<SurfaceResult>();
    result->symmetry = sketch.symmetry;
    result->warnings = sketch.warnings;
    result->timings = state.timings;
    result->segmentation = state.labels->segmentation;
    result->proxy = state.proxy->proxy;
    finishSurface(sketch.input, sketch.frame, seamed, *state.optimized, sketch.plane, inPlane,
                  *state.association, sketch.strokes, *result);
    appendTubes(sketch, options.skeletal, *result);
    state.surface = std::move(result);
    return state;
}

} // namespace ductus
