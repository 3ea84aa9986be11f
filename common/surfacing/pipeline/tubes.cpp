#include "surfacing/pipeline/tubes.h"

namespace ductus {

namespace {

SkeletalTubes tubesOf(const PreparedSketch &sketch, const SkeletalOptions &options)
{
    std::optional<SymmetryPlane> plane = sketch.plane;
    if (plane)
        plane->offset = plane->offset * sketch.frame.diagonal + plane->normal.dot(sketch.frame.centre);
    return skeletalTubes(sketch.input, sketch.frame.diagonal, plane, options);
}

void append(const SkeletalTubes &tubes, TriangleMesh &mesh, std::vector<int> &triangleRegions,
            std::vector<SurfaceRegion> &regions)
{
    const int firstVertex = mesh.vertexCount();
    const std::size_t firstRegion = regions.size();
    for (StrokeId stroke : tubes.tubes) {
        regions.emplace_back();
        regions.back().tubeOf = stroke;
    }
    mesh.vertices.insert(mesh.vertices.end(), tubes.mesh.vertices.begin(), tubes.mesh.vertices.end());
    for (std::size_t t = 0; t < tubes.mesh.triangles.size(); ++t) {
        const Triangle &corners = tubes.mesh.triangles[t];
        mesh.triangles.push_back(
            {firstVertex + corners[0], firstVertex + corners[1], firstVertex + corners[2]});
        const std::size_t region = firstRegion + std::size_t(tubes.triangleTubes[t]);
        triangleRegions.push_back(int(region));
        regions[region].area += 0.5 * tubes.mesh.areaVector(int(t)).norm();
    }
}

} // namespace

void appendTubes(const PreparedSketch &sketch, const SkeletalOptions &options, SurfaceResult &result)
{
    const SkeletalTubes tubes = tubesOf(sketch, options);
    append(tubes, result.mesh, result.triangleRegions, result.regions);
    result.warnings.insert(result.warnings.end(), tubes.warnings.begin(), tubes.warnings.end());
}

void appendTubes(const PreparedSketch &sketch, const SkeletalOptions &options, LabelPreview &preview)
{
    const SkeletalTubes tubes = tubesOf(sketch, options);
    append(tubes, preview.mesh, preview.triangleRegions, preview.regions);
    for (std::size_t i = 0; i < tubes.tubes.size(); ++i) {
        // Those of surface regions count up from 0.
        const bool isImage = i > 0 && tubes.tubes[i] == tubes.tubes[i - 1];
        preview.regionIds.push_back(-2 * (tubes.tubes[i].value + 1) - (isImage ? 1 : 0));
        preview.regionIsLocked.push_back(0);
    }
}

} // namespace ductus
