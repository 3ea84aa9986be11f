#include "layerpainter/document/export_mesh.h"

#include "formats/mesh_file.h"
#include "layerpainter/document/default_view.h"
#include "painting/bake/bake.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr const char *attempted = "Exporting the painting";
constexpr double finestShare = 1.0 / 600;  // of the painting's diagonal, if nothing else is wished
constexpr double coarsestShare = 1.0 / 40; // coarser, layers would be smeared beyond recognition

Result<std::vector<BakedStack>> bake(const Painting &painting, const MeshExportOptions &options,
                                     double &edgeLength, const JobControl &control)
{
    BakeOptions baking;
    baking.moment = options.moment;
    if (options.edgeLength != 0) {
        edgeLength = baking.edgeLength = options.edgeLength;
        return bakePainting(painting, baking, control);
    }
    const double diagonal = paintingBox(painting).diagonal();
    baking.edgeLength = diagonal > 0 ? diagonal * finestShare : 1;
    const std::int64_t most = baking.maxVertices;
    while (true) {
        const bool isLast = baking.edgeLength >= diagonal * coarsestShare;
        baking.maxVertices = isLast ? most : comfortableVertices;
        Result<std::vector<BakedStack>> baked = bakePainting(painting, baking, control);
        edgeLength = baking.edgeLength;
        if (baked || isLast || baked.error().code != ErrorCode::TooLarge)
            return baked;
        baking.edgeLength *= 1.5;
    }
}

} // namespace

Result<ExportedMesh> exportedMesh(const Painting &painting, const MeshExportOptions &options,
                                  const JobControl &control)
{
    ExportedMesh exported;
    Result<std::vector<BakedStack>> baked =
        bake(painting, options, exported.edgeLength, control.part(0, 0.9));
    if (!baked)
        return baked.error();
    MeshFileContent content;
    for (BakedStack &stack : *baked) {
        const int first = content.mesh.vertexCount();
        for (const Vec3 &vertex : stack.mesh.vertices)
            content.mesh.vertices.push_back(painting.metresPerUnit * vertex);
        for (const Eigen::Vector4f &colour : stack.colours)
            content.vertexColours.push_back(colour.cwiseMax(0.f).cwiseMin(1.f));
        for (const Triangle &t : stack.mesh.triangles)
            content.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        content.triangleRegions.resize(content.mesh.triangles.size(), exported.stacks);
        content.regionNames.push_back(stack.name);
        ++exported.stacks;
        stack = {}; // both at once would take twice the memory
    }
    if (content.mesh.isEmpty())
        return Error{ErrorCode::TooLittleData, attempted, "no stack of it is visible",
                     "Show a stack that has strokes", ""};
    exported.vertices = content.mesh.vertexCount();
    exported.triangles = content.mesh.triangleCount();
    control.progress(0.9, "Writing the mesh");
    Result<std::string> bytes = meshBytes(content, ".glb", control.part(0.9, 1.0));
    if (!bytes)
        return bytes.error();
    exported.bytes = std::move(*bytes);
    return exported;
}

} // namespace ductus
