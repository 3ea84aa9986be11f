// Props and the paintings they are copies of: taken from a project, and what is newer there.
#pragma once

#include "doodling/canvas/canvas.h"
#include "project/links/link_sources.h"

namespace ductus {

/// A prop of the painting in \a document, placed at nothing yet. \a file: DocumentLink::file. Errors: those
/// of paintingOf(), TooLittleData for a painting without strokes.
Result<Prop> linkedProp(const ProjectDocument &document, const std::string &file);

/// The painting that \a project is about: its first. Errors: as above.
Result<Prop> propFromProject(const Project &project, const std::string &file);

struct PropLink
{
    CanvasId canvas;
    DocumentLink link;                  // as the scene has it
    std::shared_ptr<const Prop> update; // null: nothing is newer
    std::optional<Error> problem;       // why nobody knows
};

/// All props of \a scene. Reads files: for workers. \a sources must read paintings.
std::vector<PropLink> propLinks(const DoodleScene &scene, LinkSources &sources);

/// \a scene with what is newer; where, how large and in which look props stand stays.
DoodleScene withUpdatedProps(const DoodleScene &scene, const std::vector<PropLink> &links);

} // namespace ductus
