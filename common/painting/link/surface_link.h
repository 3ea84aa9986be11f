// Surfaces of SketchSurfacer in a painting, linked to the sketch they came from, and what is newer there.
#pragma once

#include "painting/scene/painting.h"
#include "project/links/link_sources.h"

namespace ductus {

/// The finished surface of \a document (it has one) in the colour of clay, linked to it. \a file:
/// DocumentLink::file.
MeshShape linkedSurface(const ProjectDocument &document, const std::string &file);

/// A sketch that surfaces of the painting were made from.
struct SurfaceLink
{
    DocumentLink link;               // as the painting has it
    std::vector<ElementId> elements; // made from it, in the order of layers
    /// What update() gives elements and their new shapes: empty if nothing is newer.
    std::vector<ElementId> outdated;
    std::vector<std::shared_ptr<const ElementShape>> updates; // one each of \a outdated
    std::optional<Error> problem;                             // why nobody knows whether there is
    bool isOutdated() const { return !outdated.empty(); }
};

/// All links of \a painting in the order they are met, with what is newer behind them. Reads files: for
/// workers.
std::vector<SurfaceLink> surfaceLinks(const Painting &painting, LinkSources &sources);

/// \a mesh with the colours of \a old: its one colour, or at each corner that of the nearest old one, so that
/// what was coloured stays coloured.
std::vector<Eigen::Vector3f> coloursCarriedOver(const MeshShape &old, const TriangleMesh &mesh);

} // namespace ductus
