#include "layerpainter/document/painting_project.h"

#include "base/random.h"
#include "base/sha256.h"

#include <algorithm>

namespace ductus {

Result<StoredPainting> paintingFromProject(const Project &project)
{
    std::optional<Error> error;
    for (const ProjectDocument &document : project.documents) {
        if (document.kind != paintingKindName)
            continue;
        Result<std::shared_ptr<const PaintingContent>> content = paintingOf(document);
        if (content)
            return StoredPainting{document.id, document.name, *content};
        if (!error)
            error = content.error();
    }
    if (error)
        return *error;
    return Error{ErrorCode::TooLittleData, "Opening the painting", "the project holds no painting",
                 "Open it in the app that made it", ""};
}

void putPainting(std::shared_ptr<const PaintingContent> content, const Uuid &id, const std::string &name,
                 Project &project)
{
    if (ProjectDocument *document = project.find(id)) {
        document->content = std::move(content);
        document->name = name;
        return;
    }
    project.documents.push_back(newDocument(id, name, std::move(content)));
}

Project projectOf(const Painting &painting, const std::string &name)
{
    auto content = std::make_shared<const PaintingContent>(painting, UnknownPaintingMembers());
    BufferPacker packer;
    const std::string text = name + jsonText(content->toJson(Uuid(), packer)); // names its buffers by hash
    Random random(std::stoull(sha256Hex(asBytes(text)).substr(0, 16), nullptr, 16));
    Project project;
    project.generator = "LayerPainter";
    project.id = Uuid::from(random);
    putPainting(std::move(content), Uuid::from(random), name, project);
    return project;
}

} // namespace ductus
