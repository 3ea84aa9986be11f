// A painting in a project file and out of it.
#pragma once

#include "painting/storage/painting_content.h"
#include "project/project.h"

namespace ductus {

struct StoredPainting
{
    Uuid documentId;
    std::string name;
    std::shared_ptr<const PaintingContent> content;
};

/// The first painting of \a project that can be read. TooLittleData if there is none, NewerVersion if there
/// is but a newer version made it.
Result<StoredPainting> paintingFromProject(const Project &project);

/// Puts the painting in the place of the document \a id, or beside the others.
void putPainting(std::shared_ptr<const PaintingContent> content, const Uuid &id, const std::string &name,
                 Project &project);

/// A project of this painting alone whose ids are drawn from the content: same painting, same bytes.
Project projectOf(const Painting &painting, const std::string &name);

} // namespace ductus
