#include "surfacing/pipeline/preparation.h"

#include "strokes/resample.h"
#include "surfacing/association/held_points.h"
#include "surfacing/extraction/half_mesh.h"
#include "surfacing/parts/part_proxy.h"
#include "surfacing/pipeline/stopwatch.h"
#include "surfacing/sketch/point_cloud.h"
#include "surfacing/sketch/stray_strokes.h"

#include <algorithm>
#include <limits>

namespace ductus {

namespace {

// Even steps, so that associations and fits see strokes and not the sampling of the drawing program.
StrokeSet evenStrokes(StrokeSet strokes, double step)
{
    for (Stroke &stroke : strokes.strokes)
        stroke = resampled(stroke, step);
    return strokes;
}

StrokeSet preparedStrokes(const StrokeSet &strokes, const UnitFrame &frame, double step)
{
    if (isPointCloud(strokes))
        return inUnitFrame(cleanedCloud(strokes), frame);
    return evenStrokes(inUnitFrame(cleaned(strokes), frame), step);
}

// Coordinates that cannot tell a thousandth of the sketch apart.
bool digitsAreLost(const UnitFrame &frame)
{
    return frame.diagonal < 1e3 * std::numeric_limits<double>::epsilon() * frame.centre.cwiseAbs().maxCoeff();
}

// Bodies are told apart only where a tube joins them: without, gaps are places where little was drawn.
bool hasTubes(const StrokeSet &strokes)
{
    return std::any_of(strokes.strokes.begin(), strokes.strokes.end(),
                       [](const Stroke &stroke) { return stroke.role == StrokeRole::Skeletal; });
}

} // namespace

Result<void> prepareSketch(SurfacingState &state, const StrokeSet &strokes)
{
    Stopwatch watch;
    const SurfaceOptions &options = state.options;
    auto sketch = std::make_shared<PreparedSketch>();
    sketch->input = strokes;
    const StraysFound drawn = withStraysIgnored(strokes);
    if (drawn.count > 0)
        sketch->warnings.push_back(
            (drawn.count == 1 ? std::string("A dab") : std::to_string(drawn.count) + " dabs") +
            " in the air, far from all other strokes, left out.");
    sketch->frame = unitFrameOf(drawn.strokes);
    if (digitsAreLost(sketch->frame))
        return Error{ErrorCode::InvalidArgument, "Reading the sketch's size",
                     "the sketch is so small for its distance from the origin that its digits are lost",
                     "Move it to the origin in the program it comes from and export it again", ""};
    if (isPointCloud(strokes))
        if (Result<void> isSurface = checkCloudIsSurface(strokes); !isSurface)
            return isSurface;
    sketch->strokes = preparedStrokes(drawn.strokes, sketch->frame, options.resamplingStep);
    if (options.symmetry == SymmetryMode::Given)
        sketch->plane = sketch->frame.unitFromInput(options.symmetryPlane);
    if (options.symmetry == SymmetryMode::Auto) {
        sketch->symmetry = detectSymmetry(sketch->strokes, options.symmetryDetection);
        if (sketch->symmetry)
            sketch->plane = sketch->symmetry->plane;
        else
            sketch->warnings.push_back("No mirror plane was found; the whole sketch is surfaced.");
    }
    if (sketch->plane) {
        sketch->plane = towardsFullerSide(*sketch->plane, sketch->strokes);
        sketch->strokes = keptHalf(sketch->strokes, *sketch->plane);
    }
    state.sketch = std::move(sketch);
    state.timings.proxy = watch.lap();
    return {};
}

StrokeSet strokesInFrame(const StrokeSet &strokes, const PreparedSketch &sketch,
                         const SurfaceOptions &options)
{
    StrokeSet result =
        preparedStrokes(withStraysIgnored(strokes).strokes, sketch.frame, options.resamplingStep);
    return sketch.plane ? keptHalf(result, *sketch.plane) : result;
}

Result<void> prepareProxy(SurfacingState &state, const std::optional<TriangleMesh> &givenProxy,
                          const JobControl &control)
{
    Stopwatch watch;
    const PreparedSketch &sketch = *state.sketch;
    const StrokeSet whole = sketch.plane ? withMirrorImage(sketch.strokes, *sketch.plane) : sketch.strokes;
    Result<Proxy> proxy = givenProxy ? proxyFromMesh(inUnitFrame(*givenProxy, sketch.frame), whole,
                                                     state.options.proxy, control)
                          : hasTubes(sketch.input) ? makePartProxy(whole, state.options.proxy, {}, control)
                                                   : makeProxy(whole, state.options.proxy, control);
    if (!proxy)
        return proxy.error();
    if (sketch.plane)
        proxy->mesh = keptHalf(proxy->mesh, *sketch.plane);
    state.roughProxy = std::make_shared<const Proxy>(std::move(*proxy));
    state.givenProxy = givenProxy ? std::make_shared<const TriangleMesh>(*givenProxy) : nullptr;
    state.strokeUpdates = 0;
    state.timings.proxy += watch.lap();
    return {};
}

Result<void> prepareAssociation(SurfacingState &state, const JobControl &control)
{
    Stopwatch watch;
    const PreparedSketch &sketch = *state.sketch;
    const SurfaceOptions &options = state.options;
    auto proxy = std::make_shared<const PreparedProxy>(*state.roughProxy, StrokeSet());
    Result<Association> association =
        associate(sketch.strokes, proxy->proxy.mesh, proxy->topology, options.association, control);
    if (!association)
        return association.error();
    if (proxy->proxy.isOpen) {
        const TriangleMesh &mesh = proxy->proxy.mesh;
        const std::vector<char> inPlane =
            sketch.plane ? verticesInPlane(mesh, *sketch.plane) : std::vector<char>();
        Result<TrimmedProxy> inside =
            trimmed(mesh, proxy->topology, *association, sketch.strokes, inPlane, options.trim, control);
        if (!inside)
            return inside.error();
        Proxy cut = proxy->proxy;
        cut.mesh = std::move(inside->mesh);
        proxy = std::make_shared<const PreparedProxy>(std::move(cut), std::move(inside->borderStrokes));
        association =
            associate(sketch.strokes, proxy->proxy.mesh, proxy->topology, options.association, control);
        if (!association)
            return association.error();
    }
    holdFlatEnds(*association, proxy->proxy.flatEnds, proxy->proxy.mesh, proxy->nearest);
    state.proxy = std::move(proxy);
    state.proxyInInput = proxyToShow(state);
    state.association = std::make_shared<const Association>(std::move(*association));
    state.timings.association = watch.lap();
    return {};
}

std::shared_ptr<const TriangleMesh> proxyToShow(const SurfacingState &state)
{
    const std::optional<SymmetryPlane> &plane = state.sketch->plane;
    TriangleMesh whole = state.proxy->proxy.mesh;
    if (plane)
        whole = withMirrorImage(whole, *plane, verticesInPlane(whole, *plane)).mesh;
    return std::make_shared<const TriangleMesh>(inInputFrame(whole, state.sketch->frame));
}

} // namespace ductus
