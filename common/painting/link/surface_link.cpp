#include "painting/link/surface_link.h"

#include "base/parallel.h"
#include "geometry/point_tree.h"
#include "project/links/surface_digest.h"

#include <algorithm>
#include <map>

namespace ductus {

namespace {

const Eigen::Vector3f clay(0.52f, 0.47f, 0.42f); // linear; light enough for shadows and highlights to show

// The shape as it is now; null if it is as it was.
Result<std::shared_ptr<const ElementShape>> newerShape(const MeshShape &old, LinkSources &sources)
{
    const Result<const ProjectDocument *> found = sources.find(*old.link, sketchSurfaceKind);
    if (!found)
        return found.error();
    const ProjectDocument &document = **found;
    if (!document.sketchSurface || !document.sketchSurface->surface)
        return Error{ErrorCode::TooLittleData, "Looking for changes of \"" + old.link->name + "\"",
                     "it has no finished surface now", "Surface it in SketchSurfacer and save it",
                     sources.fileOf(*old.link).string()};
    if (surfaceDigest(*document.sketchSurface->surface) == old.link->digest)
        return std::shared_ptr<const ElementShape>();
    MeshShape shape = linkedSurface(document, old.link->file);
    shape.vertexColours = coloursCarriedOver(old, shape.mesh);
    return std::make_shared<const ElementShape>(std::move(shape));
}

} // namespace

MeshShape linkedSurface(const ProjectDocument &document, const std::string &file)
{
    const StoredSurface &surface = *document.sketchSurface->surface;
    MeshShape shape;
    shape.mesh = surface.mesh;
    shape.vertexColours.assign(shape.mesh.vertices.size(), clay);
    shape.link = DocumentLink{file, document.id, document.name, surfaceDigest(surface)};
    return shape;
}

std::vector<SurfaceLink> surfaceLinks(const Painting &painting, LinkSources &sources)
{
    std::vector<SurfaceLink> links;
    std::map<const ElementShape *, std::shared_ptr<const ElementShape>> newer; // duplicates go on sharing
    const auto visit = [&](const Element &element) {
        const auto *mesh = std::get_if<MeshShape>(element.shape.get());
        if (!mesh || !mesh->link)
            return;
        auto link = std::ranges::find_if(
            links, [&](const SurfaceLink &one) { return one.link.isOfSameDocument(*mesh->link); });
        if (link == links.end())
            link = links.insert(links.end(), {*mesh->link, {}, {}, {}, {}});
        link->elements.push_back(element.id);
        const auto [known, isNew] = newer.try_emplace(element.shape.get());
        if (isNew) {
            Result<std::shared_ptr<const ElementShape>> shape = newerShape(*mesh, sources);
            if (shape)
                known->second = std::move(*shape);
            else if (!link->problem)
                link->problem = shape.error();
        }
        if (known->second) {
            link->outdated.push_back(element.id);
            link->updates.push_back(known->second);
        }
    };
    for (const Layer *layer : painting.layers())
        for (const Drawing &drawing : layer->drawings)
            std::ranges::for_each(drawing.elements, visit);
    return links;
}

std::vector<Eigen::Vector3f> coloursCarriedOver(const MeshShape &old, const TriangleMesh &mesh)
{
    const auto &colours = old.vertexColours;
    const bool isOneColour =
        std::ranges::all_of(colours, [&](const Eigen::Vector3f &colour) { return colour == colours[0]; });
    std::vector<Eigen::Vector3f> carried(mesh.vertices.size(), colours.empty() ? clay : colours[0]);
    if (isOneColour)
        return carried;
    const PointTree tree(old.mesh.vertices);
    parallelFor(0, carried.size(), [&](std::size_t v) {
        carried[v] = colours[std::size_t(tree.nearest(mesh.vertices[v], 1).front())];
    });
    return carried;
}

} // namespace ductus
