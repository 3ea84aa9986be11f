#include "sketchsurfacer/cli/surface_report.h"

#include "geometry/mesh_topology.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

// Six significant digits: enough to compare, short enough to read.
double rounded(double value)
{
    if (value == 0.0 || !std::isfinite(value))
        return 0.0;
    const double scale = std::pow(10.0, 5 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

} // namespace

nlohmann::ordered_json surfaceReport(const std::string &input, int scribbles, const StrokeSet &strokes,
                                     const SurfaceOptions &options, const SurfaceResult &result)
{
    using Json = nlohmann::ordered_json;
    const ManifoldReport manifold = manifoldReport(result.mesh);
    Json report;
    report["schema"] = "surface-report";
    report["version"] = 1;
    report["input"] = input;
    report["strokes"] = strokes.strokes.size();
    report["points"] = strokes.pointCount();
    report["diagonal"] = rounded(strokes.box().diagonal());

    report["options"] = {{"epsilon", options.segmentation.epsilon},
                         {"simplicity", options.segmentation.simplicity},
                         {"smoothness", options.segmentation.smoothness},
                         {"runs", options.segmentation.runs},
                         {"seed", options.segmentation.seed},
                         {"scribbles", scribbles}};
    report["proxy"] = {{"kind", proxyKindName(result.proxy.kind)},
                       {"vertices", result.proxy.mesh.vertexCount()},
                       {"open", result.proxy.isOpen},
                       {"alpha", rounded(result.proxy.alpha)},
                       {"lambda", rounded(result.proxy.lambda)},
                       {"remarks", result.proxy.remarks}};
    if (result.symmetry)
        report["symmetry"] = {
            {"normal",
             {rounded(result.symmetry->plane.normal.x()), rounded(result.symmetry->plane.normal.y()),
              rounded(result.symmetry->plane.normal.z())}},
            {"offset", rounded(result.symmetry->plane.offset)},
            {"matchedShare", rounded(result.symmetry->matchedShare)},
            {"residual", rounded(result.symmetry->residual)}};

    report["mesh"] = {
        {"vertices", result.mesh.vertexCount()},     {"triangles", result.mesh.triangleCount()},
        {"borderEdges", manifold.borderEdges},       {"components", manifold.components},
        {"manifold", manifold.isManifold()},         {"watertight", manifold.isClosed()},
        {"area", rounded(surfaceArea(result.mesh))}, {"featureLines", result.featureLines.size()}};
    Json regions = Json::array();
    for (const SurfaceRegion &region : result.regions) {
        Json entry = {{"degree", region.degree}, {"area", rounded(region.area)}};
        if (region.tubeOf)
            entry["tubeOfStroke"] = region.tubeOf->value;
        regions.push_back(std::move(entry));
    }
    report["regions"] = regions;

    const Segmentation &s = result.segmentation;
    Json runs = Json::array();
    for (double energy : s.runEnergies)
        runs.push_back(rounded(energy));
    report["energy"] = {{"total", rounded(s.energy)},
                        {"fidelity", rounded(s.fidelity)},
                        {"smoothness", rounded(s.smoothness)},
                        {"simplicity", rounded(s.simplicity)},
                        {"models", s.models.size()},
                        {"iterations", s.iterations},
                        {"runs", runs}};
    report["deviationPercent"] = {{"median", rounded(100 * result.deviation.median)},
                                  {"mean", rounded(100 * result.deviation.mean)},
                                  {"p95", rounded(100 * result.deviation.p95)},
                                  {"max", rounded(100 * result.deviation.max)}};
    Json perStroke = Json::array();
    for (double d : result.strokeDeviation)
        perStroke.push_back(d < 0 ? Json(nullptr) : Json(rounded(100 * d)));
    report["strokeDeviationPercent"] = perStroke;
    report["seconds"] = {{"proxy", rounded(result.timings.proxy)},
                         {"association", rounded(result.timings.association)},
                         {"segmentation", rounded(result.timings.segmentation)},
                         {"extraction", rounded(result.timings.extraction)},
                         {"total", rounded(result.timings.total)}};
    report["warnings"] = result.warnings;
    return report;
}

} // namespace ductus
