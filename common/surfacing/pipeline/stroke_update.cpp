#include "surfacing/pipeline/stroke_update.h"

#include "surfacing/association/held_points.h"
#include "surfacing/pipeline/local_attraction.h"
#include "surfacing/pipeline/preparation.h"
#include "surfacing/pipeline/stopwatch.h"
#include "surfacing/refinement/stroke_refit.h"
#include "surfacing/sketch/stray_strokes.h"

#include <algorithm>
#include <set>

namespace ductus {

namespace {

// Input coordinates, even steps, only the solved half: laid whole on a half proxy a stroke through the plane
// would run back on itself.
std::vector<Stroke> solvedHalf(const SurfacingState &state, const std::vector<Stroke> &strokes)
{
    StrokeSet set;
    set.strokes = strokes;
    set = strokesInFrame(set, *state.sketch, state.options);
    for (Stroke &stroke : set.strokes)
        for (Vec3 &p : stroke.points)
            p = state.sketch->frame.inputFromUnit(p);
    return set.strokes;
}

std::vector<Vec3> unitPoints(const SurfacingState &state, const std::vector<Stroke> &strokes)
{
    std::vector<Vec3> points;
    for (const Stroke &stroke : strokes)
        for (const Vec3 &p : stroke.points)
            points.push_back(state.sketch->frame.unitFromInput(p));
    return points;
}

// Nearest to an edge where the surface ends: not one in the symmetry plane.
bool isAtBorder(const SurfacingState &state, const NearestPoint &foot)
{
    constexpr double inPlane = 1e-6;
    const PreparedProxy &proxy = *state.proxy;
    for (int e : proxy.topology.faceEdges[std::size_t(foot.triangle)]) {
        if (!proxy.topology.isBorder(e))
            continue;
        const MeshEdge &edge = proxy.topology.edges[std::size_t(e)];
        const Vec3 middle = 0.5 * (proxy.proxy.mesh.vertices[std::size_t(edge.v0)] +
                                   proxy.proxy.mesh.vertices[std::size_t(edge.v1)]);
        if (!state.sketch->plane || std::abs(state.sketch->plane->signedDistance(middle)) > inPlane)
            return true;
    }
    return false;
}

struct Reach
{
    double farthest = 0.0; // of an added point from the proxy
    bool leavesSheet = false;
};

Reach reachOf(const SurfacingState &state, const std::vector<Vec3> &added, double tolerance)
{
    Reach reach;
    for (const Vec3 &p : added) {
        const NearestPoint foot = state.proxy->nearest.nearest(p);
        reach.farthest = std::max(reach.farthest, foot.distance);
        reach.leavesSheet |= foot.distance > tolerance && isAtBorder(state, foot);
    }
    return reach;
}

// Whether a stroke went that was found to border the surface.
bool hasBorderOf(const SurfacingState &before, const StrokeDifference &change)
{
    for (const Stroke &border : before.proxy->borderStrokes.strokes)
        for (const Stroke &removed : change.removed)
            if (border.id == removed.id)
                return true;
    return false;
}

// Whether nothing but the roles of just those strokes changed that the surface was found to end along: what
// they are marked as now it was cut by already.
bool marksWhatWasFound(const SurfacingState &before, const StrokeSet &strokes)
{
    const std::vector<Stroke> &old = before.sketch->input.strokes;
    if (before.sketch->plane || old.size() != strokes.strokes.size())
        return false;
    std::set<int> found, marked;
    for (const Stroke &border : before.proxy->borderStrokes.strokes)
        found.insert(border.id.value);
    for (std::size_t i = 0; i < old.size(); ++i) {
        const Stroke &a = old[i], &b = strokes.strokes[i];
        const bool isMarked = b.role == StrokeRole::Boundary;
        if (a.id != b.id || a.points != b.points || (a.role != b.role && !isMarked))
            return false;
        if (isMarked)
            marked.insert(b.id.value);
    }
    return !found.empty() && found == marked;
}

SurfacingState withStrokes(const SurfacingState &before, const StrokeSet &strokes)
{
    SurfacingState state = before;
    auto sketch = std::make_shared<PreparedSketch>(*before.sketch);
    sketch->input = strokes;
    sketch->strokes = strokesInFrame(strokes, *sketch, state.options);
    sketch->warnings.clear();
    state.sketch = std::move(sketch);
    return state;
}

std::string refusalOf(const SurfacingState &before, const StrokeSet &strokes, const StrokeDifference &change,
                      const StrokeUpdateOptions &options)
{
    double length = 0.0;
    for (const Stroke &stroke : strokes.strokes)
        length += polylineLength(stroke.points);
    if (change.length() > options.largestChange * length)
        return "much of the sketch has changed";
    const double growth =
        unitFrameOf(withStraysIgnored(strokes).strokes).diagonal / before.sketch->frame.diagonal;
    if (std::abs(growth - 1.0) > options.largestGrowth)
        return "the sketch has another size now";
    // Border strokes decide where an open surface ends, or whether it is open.
    if (change.hasBoundaryStrokes() || hasBorderOf(before, change))
        return "boundary strokes have changed";
    return "";
}

Result<void> attractProxy(SurfacingState &state, const std::vector<Vec3> &changed, const JobControl &control)
{
    LocalAttractionOptions options;
    options.maxDistance = state.options.association.maxDistance;
    const auto pulled = [&](const Proxy &proxy) -> Result<Proxy> {
        Result<TriangleMesh> mesh =
            attractedNear(proxy.mesh, state.sketch->strokes, changed, state.sketch->plane, options, control);
        if (!mesh)
            return mesh.error();
        Proxy result = proxy;
        result.mesh = std::move(*mesh);
        return result;
    };
    Result<Proxy> rough = pulled(*state.roughProxy);
    if (!rough)
        return rough.error();
    // Open proxies were trimmed since; the cut ones keep their own vertices.
    Result<Proxy> trimmed = state.proxy->proxy.isOpen ? pulled(state.proxy->proxy) : rough;
    if (!trimmed)
        return trimmed.error();
    state.roughProxy = std::make_shared<const Proxy>(std::move(*rough));
    state.proxy = std::make_shared<const PreparedProxy>(std::move(*trimmed), state.proxy->borderStrokes);
    state.proxyInInput = proxyToShow(state);
    return {};
}

// A profile drawn across an end says that it is a dome after all.
void dropContradictedEnds(SurfacingState &state, const std::vector<Vec3> &added)
{
    Proxy proxy = state.proxy->proxy;
    proxy.flatEnds = stillFlat(proxy.flatEnds, added, state.options.proxy.flatEnds);
    if (proxy.flatEnds.size() != state.proxy->proxy.flatEnds.size())
        state.proxy = std::make_shared<const PreparedProxy>(std::move(proxy), state.proxy->borderStrokes);
}

} // namespace

Result<StrokeUpdate> updateStrokes(const SurfacingState &before, const StrokeSet &strokes,
                                   const StrokeUpdateOptions &options, const JobControl &control)
{
    Stopwatch watch;
    StrokeDifference change = differenceBetween(before.sketch->input, strokes);
    StrokeUpdate update;
    if (marksWhatWasFound(before, strokes)) {
        update.state = withStrokes(before, strokes);
        update.isSolved = true;
        return update;
    }
    update.refusal = refusalOf(before, strokes, change, options);
    if (!update.refusal.empty())
        return update;

    SurfacingState state = withStrokes(before, strokes);
    change = {solvedHalf(state, change.removed), solvedHalf(state, change.added)};
    std::vector<Vec3> changed = unitPoints(state, change.added);
    const Reach reach = reachOf(state, changed, options.attractFrom);
    if (reach.farthest > state.options.association.maxDistance || reach.leavesSheet) {
        update.refusal = "a changed stroke runs away from the surface";
        return update;
    }
    if (reach.farthest > options.attractFrom) {
        const std::vector<Vec3> removed = unitPoints(state, change.removed);
        changed.insert(changed.end(), removed.begin(), removed.end());
        if (Result<void> done = attractProxy(state, changed, control.part(0.0, 0.3)); !done) {
            if (done.error().isCancelled())
                return done.error();
            update.refusal = "the proxy cannot follow the changed strokes";
            return update;
        }
    }
    dropContradictedEnds(state, unitPoints(state, change.added));
    state.timings.proxy = watch.lap();

    Result<Association> association =
        associate(state.sketch->strokes, state.proxy->proxy.mesh, state.proxy->topology,
                  state.options.association, control.part(0.3, 0.6));
    if (!association)
        return association.error();
    holdFlatEnds(*association, state.proxy->proxy.flatEnds, state.proxy->proxy.mesh, state.proxy->nearest);
    state.association = std::make_shared<const Association>(std::move(*association));
    state.timings.association = watch.lap();

    const ScribbleDomain domain{state.proxy->proxy.mesh, state.proxy->topology, state.proxy->nearest,
                                *state.association,      state.sketch->frame,   state.sketch->plane};
    Result<std::shared_ptr<const LabelSolution>> labels =
        refitted(domain, *before.labels, change, state.options.segmentation, control.part(0.6, 1.0));
    if (!labels)
        return labels.error();
    state.labels = std::move(*labels);
    ++state.strokeUpdates;
    state.timings.segmentation = watch.lap();
    update.state = std::move(state);
    return update;
}

} // namespace ductus
