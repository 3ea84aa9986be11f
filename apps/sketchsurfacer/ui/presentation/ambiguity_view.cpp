#include "sketchsurfacer/ui/presentation/ambiguity_view.h"

#include "geometry/nearest.h"
#include "imaging/region_colours.h"
#include "imaging/surface_picture.h"
#include "surfacing/pipeline/ambiguity.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace ductus {

namespace {

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

// The colour furthest from all of \a used.
Rgba unusedColour(const std::vector<Rgba> &used)
{
    Rgba best = regionColour(0);
    double largest = -1.0;
    for (int number = 0; number < regionColourCount; ++number) {
        double nearest = 1e9;
        for (const Rgba &other : used)
            nearest = std::min(nearest, colourDistance(regionColour(number), other));
        if (nearest > largest) {
            largest = nearest;
            best = regionColour(number);
        }
    }
    return best;
}

// A region has the colour of the present one it covers most of, so that only what differs looks other.
std::vector<Rgba> matchedColours(const LabelPreview &reading, const ResultView &result,
                                 const NearestOnMesh &present)
{
    const std::size_t here = result.regionViews.size(), there = reading.regions.size();
    std::vector<double> shared(here * there, 0.0);
    for (int t = 0; t < reading.mesh.triangleCount(); ++t) {
        const NearestPoint near = present.nearest(reading.mesh.centroid(t));
        const auto region = std::size_t(result.triangleRegions[std::size_t(near.triangle)]);
        shared[std::size_t(reading.triangleRegions[std::size_t(t)]) * here + region] +=
            reading.mesh.areaVector(t).norm();
    }
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t r = 0; r < there; ++r)
        for (std::size_t p = 0; p < here; ++p)
            if (shared[r * here + p] > 0.0)
                pairs.emplace_back(-shared[r * here + p], r, p);
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> hasColour(there, 0), isTaken(here, 0);
    std::vector<Rgba> colours(there), used;
    for (const auto &[area, r, p] : pairs)
        if (!hasColour[r] && !isTaken[p]) {
            hasColour[r] = isTaken[p] = 1;
            colours[r] = result.regionViews[p].colour;
            used.push_back(colours[r]);
        }
    for (std::size_t r = 0; r < there; ++r)
        if (!hasColour[r]) {
            colours[r] = unusedColour(used);
            used.push_back(colours[r]);
        }
    return colours;
}

Image pictureOf(const LabelPreview &reading, const std::vector<Rgba> &colours, UpAxis up,
                const ReadingPictureOptions &pictures)
{
    PictureScene scene;
    PictureMesh mesh;
    mesh.mesh = reading.mesh;
    for (int region : reading.triangleRegions)
        mesh.triangleColours.push_back(colours[std::size_t(region)]);
    scene.meshes.push_back(std::move(mesh));
    PictureOptions options;
    options.width = pictures.width;
    options.height = pictures.height;
    options.softLight = false;
    options.groundShadow = false;
    options.margin = 0.04;
    options.backgroundTop = options.backgroundBottom = pictures.background;
    options.zUp = up == UpAxis::Z;
    const Vec3 eye = pictures.towardsEye.normalized();
    options.elevationDegrees = degrees(std::asin(std::clamp(options.zUp ? eye.z() : eye.y(), -1.0, 1.0)));
    options.azimuthDegrees = degrees(std::atan2(eye.x(), options.zUp ? -eye.y() : eye.z()));
    return renderPicture(scene, options);
}

} // namespace

Result<std::shared_ptr<const AmbiguityView>> makeAmbiguityView(std::shared_ptr<const ResultView> result,
                                                               UpAxis up,
                                                               const ReadingPictureOptions &pictures,
                                                               const JobControl &control)
{
    const SurfacingState &state = *result->state;
    Result<Ambiguity> found = findAmbiguity(state, {}, control.part(0.0, 0.8));
    if (!found)
        return found.error();
    auto view = std::make_shared<AmbiguityView>();
    view->of = result;
    const TriangleMesh &proxy = *state.proxyInInput, &mesh = *result->regions.mesh;
    const NearestOnMesh onProxy(proxy);
    ShadingOptions shading;
    for (const Vec3 &p : mesh.vertices) {
        const NearestPoint near = onProxy.nearest(p);
        double value = 0.0;
        for (int k = 0; k < 3; ++k)
            value += near.barycentric[k] *
                     found->shown[std::size_t(proxy.triangles[std::size_t(near.triangle)][std::size_t(k)])];
        view->values.push_back(value);
        shading.vertexColours.push_back(ambiguityColour(value));
    }
    view->mesh.mesh = result->regions.mesh;
    view->mesh.tree = result->regions.tree;
    view->mesh.shaded = shadedMesh(mesh, shading);

    control.progress(0.85, "Drawing other readings");
    const NearestOnMesh present(mesh);
    for (const Segmentation &alternative : found->alternatives) {
        Result<SurfacingState> labelled = withAlternative(state, alternative, control.part(0.85, 1.0));
        if (!labelled)
            return labelled.error();
        Reading reading;
        reading.regionCount = int(labelled->preview->regions.size());
        reading.energy = alternative.energy / std::max(state.labels->segmentation.energy, 1e-300);
        reading.picture =
            pictureOf(*labelled->preview, matchedColours(*labelled->preview, *result, present), up, pictures);
        reading.labelled = std::make_shared<const SurfacingState>(std::move(*labelled));
        view->readings.push_back(std::move(reading));
        if (control.isCancelled())
            return cancelledError("Looking for other readings");
    }
    return std::shared_ptr<const AmbiguityView>(view);
}

} // namespace ductus
