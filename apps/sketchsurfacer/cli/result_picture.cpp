#include "sketchsurfacer/cli/result_picture.h"

#include "geometry/mesh_topology.h"
#include "imaging/region_colours.h"
#include "imaging/side_by_side.h"
#include "imaging/surface_picture.h"

#include <set>

namespace ductus {

namespace {

constexpr Rgba strokeColour{38, 52, 92, 255};

std::vector<Rgba> regionColoursOf(const SurfaceResult &result)
{
    std::set<std::pair<int, int>> neighbours;
    for (const MeshEdge &e : MeshTopology(result.mesh).edges) {
        if (e.faceCount != 2)
            continue;
        const int a = result.triangleRegions[std::size_t(e.faces[0])];
        const int b = result.triangleRegions[std::size_t(e.faces[1])];
        if (a != b)
            neighbours.emplace(std::min(a, b), std::max(a, b));
    }
    const std::vector<int> numbers =
        assignRegionColours(int(result.regions.size()), {neighbours.begin(), neighbours.end()});
    std::vector<Rgba> colours;
    for (int region : result.triangleRegions)
        colours.push_back(regionColour(numbers[std::size_t(region)]));
    return colours;
}

void addStrokes(const StrokeSet &strokes, double radius, double visibleBehind, PictureScene &scene)
{
    for (const Stroke &stroke : strokes.strokes) {
        PictureLine line;
        line.points = stroke.points;
        line.colour = strokeColour;
        line.radius = radius;
        line.visibleBehind = visibleBehind;
        scene.lines.push_back(std::move(line));
    }
}

} // namespace

Image resultPicture(const StrokeSet &strokes, const SurfaceResult &result)
{
    const double diagonal = strokes.box().diagonal();
    PictureOptions options;
    options.width = 960;
    options.height = 900;
    options.zUp = strokes.upAxis == UpAxis::Z;

    PictureScene sketch, surface, regions;
    addStrokes(strokes, diagonal / 450, 0.0, sketch);
    PictureMesh clay;
    clay.mesh = result.mesh;
    surface.meshes.push_back(clay);
    PictureMesh coloured = clay;
    coloured.triangleColours = regionColoursOf(result);
    regions.meshes.push_back(std::move(coloured));
    addStrokes(strokes, diagonal / 700, diagonal / 80, regions);
    return sideBySide(
        {renderPicture(sketch, options), renderPicture(regions, options), renderPicture(surface, options)});
}

} // namespace ductus
