#include "sketchsurfacer/ui/presentation/result_view.h"

#include "geometry/mesh_topology.h"
#include "sketchsurfacer/ui/presentation/found_borders.h"
#include "sketchsurfacer/ui/viewport/ambient_light.h"

#include <numeric>

namespace ductus {

namespace {

constexpr Rgba clay{214, 207, 197, 255};
constexpr Rgba proxyColour{150, 163, 184, 255};

std::shared_ptr<const TriangleMesh> shared(const TriangleMesh &mesh)
{
    return std::make_shared<const TriangleMesh>(mesh);
}

// A triangle of each region with the longest way, in steps over triangles, to the region's border.
std::vector<int> innermostTriangles(const TriangleMesh &mesh, const std::vector<int> &regions, int count)
{
    const MeshTopology topology(mesh);
    std::vector<int> queue, steps(mesh.triangles.size(), -1);
    const auto across = [&](int t, int k) {
        const int edge = topology.faceEdges[std::size_t(t)][std::size_t(k)];
        return edge >= 0 && topology.edges[std::size_t(edge)].faceCount == 2 ? topology.across(edge, t) : -1;
    };
    for (int t = 0; t < mesh.triangleCount(); ++t)
        for (int k = 0; k < 3 && steps[std::size_t(t)] < 0; ++k) {
            const int other = across(t, k);
            if (other < 0 || regions[std::size_t(other)] != regions[std::size_t(t)]) {
                steps[std::size_t(t)] = 0;
                queue.push_back(t);
            }
        }
    std::vector<int> innermost(std::size_t(count), -1);
    for (std::size_t i = 0; i < queue.size(); ++i) { // breadth first: the last of a region is its innermost
        const int t = queue[i];
        innermost[std::size_t(regions[std::size_t(t)])] = t;
        for (int k = 0; k < 3; ++k)
            if (const int other = across(t, k); other >= 0 && steps[std::size_t(other)] < 0) {
                steps[std::size_t(other)] = steps[std::size_t(t)] + 1;
                queue.push_back(other);
            }
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) // a region without border: a whole component
        if (int &inner = innermost[std::size_t(regions[std::size_t(t)])]; inner < 0)
            inner = t;
    return innermost;
}

ViewMesh viewMesh(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const RayTree> tree,
                  const ShadingOptions &options)
{
    ViewMesh view;
    view.shaded = shadedMesh(*mesh, options);
    view.mesh = std::move(mesh);
    view.tree = std::move(tree);
    return view;
}

} // namespace

Result<std::shared_ptr<const ResultView>> makeResultView(std::shared_ptr<const SurfacingState> state,
                                                         const StrokeSet &strokes, RegionPalette &palette,
                                                         const JobControl &control)
{
    auto view = std::make_shared<ResultView>();
    view->state = state;
    view->isPreview = !state->hasSurface();
    view->foundBorders = foundBorders(strokes, *state);
    const double diagonal = strokes.box().diagonal();

    if (state->proxyInInput) {
        ShadingOptions options;
        options.creaseAngleDegrees = 1.0; // facets: it is a rough thing
        options.colour = proxyColour;
        view->proxy =
            viewMesh(state->proxyInInput, std::make_shared<const RayTree>(*state->proxyInInput), options);
    }
    const SurfaceResult *surface = state->surface.get();
    const LabelPreview *preview = state->preview.get();
    if (!surface && !preview)
        return std::shared_ptr<const ResultView>(view);

    const std::shared_ptr<const TriangleMesh> mesh = shared(surface ? surface->mesh : preview->mesh);
    view->triangleRegions = surface ? surface->triangleRegions : preview->triangleRegions;
    const std::vector<SurfaceRegion> &regions = surface ? surface->regions : preview->regions;
    const auto tree = std::make_shared<const RayTree>(*mesh);
    std::vector<int> ids(regions.size());
    std::iota(ids.begin(), ids.end(), 0);
    if (preview && preview->regionIds.size() == regions.size())
        ids = preview->regionIds;
    const std::vector<Rgba> colours = palette.colours(*mesh, view->triangleRegions, ids);
    const std::vector<int> innermost = innermostTriangles(*mesh, view->triangleRegions, int(regions.size()));
    for (std::size_t r = 0; r < regions.size(); ++r) {
        RegionView region;
        region.colour = colours[r];
        region.degree = regions[r].degree;
        region.area = regions[r].area;
        region.isLocked = preview && r < preview->regionIsLocked.size() && preview->regionIsLocked[r];
        if (innermost[r] >= 0)
            region.inside = mesh->centroid(innermost[r]);
        view->regionViews.push_back(region);
    }

    ShadingOptions shading;
    // The preview must be quick: its light is not worth waiting for.
    if (surface)
        shading.vertexLight = ambientLight(*mesh, *tree, 0.35 * diagonal, 0.42f, control);
    for (int region : view->triangleRegions)
        shading.triangleColours.push_back(colours[std::size_t(region)]);
    view->regions = viewMesh(mesh, tree, shading);
    view->shadow = groundShadow(mesh->vertices, strokes.upAxis, 0.5);
    if (!surface)
        return std::shared_ptr<const ResultView>(view);

    shading.triangleColours.clear();
    shading.colour = clay;
    view->surface = viewMesh(mesh, tree, shading);
    for (const std::vector<int> &line : surface->featureLines) {
        std::vector<Vec3> points;
        for (int v : line)
            points.push_back(mesh->vertices[std::size_t(v)]);
        view->creases.push_back(std::move(points));
    }
    view->deviationMap = deviationMap(*mesh, view->triangleRegions, int(regions.size()), strokes, control);
    for (std::size_t r = 0; r < view->regionViews.size(); ++r)
        view->regionViews[r].deviation = view->deviationMap.regionDeviation[r];
    shading.vertexColours = view->deviationMap.vertexColours;
    view->deviation = viewMesh(mesh, tree, shading);
    view->isClosed = manifoldReport(*mesh).isClosed();
    if (control.isCancelled())
        return cancelledError("Drawing the surface");
    return std::shared_ptr<const ResultView>(view);
}

} // namespace ductus
