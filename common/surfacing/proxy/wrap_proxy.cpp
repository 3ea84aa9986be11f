#include "surfacing/proxy/wrap_proxy.h"

#include "base/parallel.h"
#include "geometry/alpha_wrap.h"
#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ductus {

namespace {

struct Candidate
{
    TriangleMesh mesh;
    double volume = 0.0, area = 0.0;
    double thinShare = 0.0; // of the area
    double buried = 0.0;    // mean depth of the strokes below the wrap, beyond where it keeps off
    int eulerNumber = 0, components = 0;
};

// Share of the area behind which the wrap comes out again within the thickness.
double thinShare(const TriangleMesh &mesh, const NearestOnMesh &nearest, double thickness)
{
    double thin = 0.0, area = 0.0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 twice = mesh.areaVector(t);
        bool isThick = true;
        for (double share : {0.4, 0.7, 1.0})
            isThick = isThick && nearest.isInside(mesh.centroid(t) - share * thickness * twice.normalized());
        area += twice.norm();
        thin += isThick ? 0.0 : twice.norm();
    }
    return area > 0.0 ? thin / area : 1.0;
}

double buriedDepth(const NearestOnMesh &nearest, const std::vector<Vec3> &points, double offset)
{
    constexpr std::size_t enough = 1500;
    const std::size_t stride = points.size() / enough + 1;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < points.size(); i += stride, ++count)
        sum += std::max(0.0, nearest.nearest(points[i]).distance - 2.0 * offset);
    return count ? sum / count : 0.0;
}

Candidate measured(TriangleMesh mesh, const std::vector<Vec3> &points, const WrapOptions &options)
{
    Candidate c;
    const MeshTopology topology(mesh);
    c.volume = signedVolume(mesh);
    c.area = surfaceArea(mesh);
    const NearestOnMesh nearest(mesh);
    c.thinShare = thinShare(mesh, nearest, options.thickness);
    c.buried = buriedDepth(nearest, points, options.offset);
    c.eulerNumber = mesh.vertexCount() - int(topology.edges.size()) + mesh.triangleCount();
    triangleComponents(topology, &c.components);
    c.mesh = std::move(mesh);
    return c;
}

std::size_t tightestSolid(const std::vector<Candidate> &candidates, const WrapOptions &options)
{
    double leastArea = candidates[0].area;
    std::size_t chosen = 0;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        leastArea = std::min(leastArea, candidates[i].area);
        // Drawing back from a concavity loses volume too, but area with it; or it uncovers strokes: the stem
        // of a lamp below its shade.
        const Candidate &c = candidates[i], &looser = candidates[i - 1];
        const bool uncovered =
            c.buried < 0.75 * looser.buried - options.leastUncovered && c.area < 1.06 * looser.area;
        const bool fellIn =
            c.volume < 0.5 * looser.volume ||
            (c.volume < options.keptVolume * looser.volume && c.area > 0.97 * looser.area && !uncovered);
        if (fellIn || candidates[i].area > options.areaGrowth * leastArea ||
            candidates[i].components > candidates[0].components)
            break;
        chosen = i;
    }
    return chosen;
}

std::optional<std::size_t> loosestShell(const std::vector<Candidate> &candidates, const WrapOptions &options)
{
    double leastArea = candidates[0].area;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate &c = candidates[i];
        leastArea = std::min(leastArea, c.area);
        if (c.thinShare >= options.shellThinShare && c.components == 1 && c.eulerNumber >= 0 &&
            c.area <= options.shellAreaGrowth * leastArea)
            return i;
    }
    return std::nullopt;
}

} // namespace

Result<Wrap> wrapStrokes(const std::vector<Vec3> &points, const WrapOptions &options,
                         const JobControl &control)
{
    control.progress(0.0, "Wrapping the strokes");
    std::vector<double> alphas = options.alphas;
    if (options.tightness >= 0.0) {
        const double place = std::clamp(options.tightness, 0.0, 1.0) * double(alphas.size() - 1);
        alphas = {alphas[std::size_t(std::lround(place))]};
    }
    std::vector<std::optional<Result<Candidate>>> wraps(alphas.size());
    parallelFor(0, alphas.size(), [&](std::size_t i) {
        if (control.isCancelled()) {
            wraps[i] = Result<Candidate>(cancelledError("Wrapping the strokes"));
            return;
        }
        Result<TriangleMesh> mesh = alphaWrap(points, {alphas[i], options.offset});
        wraps[i] = mesh ? Result<Candidate>(measured(std::move(*mesh), points, options)) : mesh.error();
    });
    std::vector<Candidate> candidates;
    for (std::optional<Result<Candidate>> &wrap : wraps) {
        if (!wrap->ok())
            return wrap->error();
        candidates.push_back(std::move(**wrap));
    }
    const std::optional<std::size_t> shell = loosestShell(candidates, options);
    const std::size_t chosen = shell ? *shell : tightestSolid(candidates, options);
    return Wrap{std::move(candidates[chosen].mesh), alphas[chosen], shell.has_value(),
                options.offset};
}

} // namespace ductus
