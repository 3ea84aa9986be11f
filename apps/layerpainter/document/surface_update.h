// The surfaces of a painting that have changed in SketchSurfacer: found on a worker, taken over as one step
// of the history.
#pragma once

#include "document/document_files.h"
#include "layerpainter/document/painting_document.h"
#include "painting/link/surface_link.h"

#include <QStringList>

namespace ductus {

/// What a worker needs to look for changes; a copy of the project, which is cheap.
struct LinkQuestion
{
    std::shared_ptr<const Painting> painting;
    Project project; // the painting's own
    std::filesystem::path file;
};

LinkQuestion linkQuestion(const PaintingDocument &document);
/// For workers.
std::vector<SurfaceLink> answered(const LinkQuestion &question);

/// The files to watch; the document's own is not among them.
QStringList linkedFiles(const PaintingDocument &document);

/// Takes what is newer; layers, strokes and masks stay as they are. One step of the history, "Update
/// surface". How many surfaces were updated; what was refused is told by the document.
int updateSurfaces(PaintingDocument &document, const std::vector<SurfaceLink> &links);

/// The digests of what is newer in one text: the same for the same offer.
QString offerOf(const std::vector<SurfaceLink> &links);

} // namespace ductus
