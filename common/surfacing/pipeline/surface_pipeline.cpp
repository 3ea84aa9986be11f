#include "surfacing/pipeline/surface_pipeline.h"

#include "strokes/resample.h"
#include "surfacing/extraction/half_mesh.h"
#include "surfacing/pipeline/finish_surface.h"
#include "surfacing/pipeline/stopwatch.h"
#include "surfacing/sketch/unit_frame.h"

namespace ductus {

namespace {

Result<Proxy> proxyFor(const StrokeSet &strokes, const std::optional<TriangleMesh> &given, const UnitFrame &frame,
                       const ProxyOptions &options, const JobControl &control)
{
    return given ? proxyFromMesh(inUnitFrame(*given, frame), strokes, options, control)
                 : makeProxy(strokes, options, control);
}

// Even steps, so that associations and fits see strokes and not the sampling of the drawing program.
StrokeSet evenStrokes(StrokeSet strokes, double step)
{
    for (Stroke &stroke : strokes.strokes)
        stroke = resampled(stroke, step);
    return strokes;
}

} // namespace

Result<SurfaceResult> surfaceSketch(const StrokeSet &input, const std::optional<TriangleMesh> &givenProxy,
                                    const SurfaceOptions &options, const JobControl &control)
{
    Stopwatch total, phase;
    SurfaceResult result;

    // sketch
    const UnitFrame frame = unitFrameOf(input);
    StrokeSet strokes = evenStrokes(inUnitFrame(cleaned(input), frame), options.resamplingStep);
    std::optional<SymmetryPlane> plane;
    if (options.symmetry == SymmetryMode::Given)
        plane = frame.unitFromInput(options.symmetryPlane);
    if (options.symmetry == SymmetryMode::Auto) {
        if (const auto proposal = detectSymmetry(strokes, options.symmetryDetection)) {
            result.symmetry = proposal;
            plane = proposal->plane;
        } else {
            result.warnings.push_back("No mirror plane was found; the whole sketch is surfaced.");
        }
    }
    if (plane) {
        plane = towardsFullerSide(*plane, strokes);
        strokes = keptHalf(strokes, *plane);
    }

    // proxy
    Result<Proxy> proxy = proxyFor(plane ? withMirrorImage(strokes, *plane) : strokes, givenProxy, frame,
                                   options.proxy, control.part(0.0, 0.45));
    if (!proxy)
        return proxy.error();
    if (plane)
        proxy->mesh = keptHalf(proxy->mesh, *plane);
    result.timings.proxy = phase.lap();

    // association, after trimming what lies beyond the border of an open surface
    const JobControl associating = control.part(0.45, 0.5);
    Result<Association> association =
        associate(strokes, proxy->mesh, MeshTopology(proxy->mesh), options.association, associating);
    if (!association)
        return association.error();
    if (proxy->isOpen) {
        const std::vector<char> inPlane = plane ? verticesInPlane(proxy->mesh, *plane) : std::vector<char>();
        Result<TriangleMesh> inside = trimmed(proxy->mesh, MeshTopology(proxy->mesh), *association, strokes, inPlane,
                                              options.trim, associating);
        if (!inside)
            return inside.error();
        proxy->mesh = std::move(*inside);
        association = associate(strokes, proxy->mesh, MeshTopology(proxy->mesh), options.association, associating);
        if (!association)
            return association.error();
    }
    const MeshTopology topology(proxy->mesh);
    result.timings.association = phase.lap();

    // segmentation
    Result<Segmentation> segmentation =
        segment(*association, topology, options.segmentation, control.part(0.5, 0.8));
    if (!segmentation)
        return segmentation.error();
    result.timings.segmentation = phase.lap();

    // extraction
    const SeamedMesh seamed = insertSeams(proxy->mesh, topology, segmentation->labels,
                                          strokeCutPositions(proxy->mesh, topology, *association));
    const std::vector<char> inPlane = plane ? verticesInPlane(seamed.mesh, *plane) : std::vector<char>();
    const Result<OptimizedMesh> optimized =
        optimizeMesh(seamed, segmentation->models, borderTargets(seamed.mesh, strokes, inPlane),
                     strokeDistances(seamed.mesh, strokes, 1.0), plane, inPlane,
                     options.extraction, control.part(0.8, 1.0));
    if (!optimized)
        return optimized.error();
    result.timings.extraction = phase.lap();

    result.segmentation = std::move(*segmentation);
    result.proxy = std::move(*proxy);
    finishSurface(input, frame, seamed, *optimized, plane, inPlane, *association, strokes, result);
    result.timings.total = total.lap();
    return result;
}

} // namespace ductus
