#include "doodling/prop/prop_link.h"

#include "painting/action/action_log.h"

#include <algorithm>

namespace ductus {

Result<Prop> linkedProp(const ProjectDocument &document, const std::string &file)
{
    Result<std::shared_ptr<const PaintingContent>> content = paintingOf(document);
    if (!content)
        return content.error();
    const Painting &painting = (*content)->painting();
    if (std::ranges::none_of(painting.stacks,
                             [](const Stack &stack) { return stack.substrate->elementCount() > 0; }))
        return Error{ErrorCode::TooLittleData, "Placing \"" + document.name + "\"",
                     "the painting has no strokes", "Paint something in LayerPainter and save it", file};
    Prop prop;
    prop.link = {file, document.id, document.name, paintingFingerprint(painting)};
    prop.painting = std::move(*content);
    return prop;
}

Result<Prop> propFromProject(const Project &project, const std::string &file)
{
    for (const ProjectDocument &document : project.documents)
        if (document.kind == paintingKindName)
            return linkedProp(document, file);
    return Error{ErrorCode::TooLittleData, "Placing a painting", "the project holds no painting",
                 "Choose a project that was saved in LayerPainter", file};
}

std::vector<PropLink> propLinks(const DoodleScene &scene, LinkSources &sources)
{
    std::vector<PropLink> links;
    for (const Canvas &canvas : scene.canvases) {
        if (!canvas.prop)
            continue;
        PropLink link{canvas.id, canvas.prop->link, nullptr, {}};
        const Result<const ProjectDocument *> document = sources.find(link.link, paintingKindName);
        if (!document) {
            link.problem = document.error();
        } else if (Result<Prop> newer = linkedProp(**document, link.link.file); !newer) {
            link.problem = newer.error();
        } else if (newer->link.digest != link.link.digest) {
            newer->look = canvas.prop->look;
            newer->placement = canvas.prop->placement;
            newer->framesPerSecond = canvas.prop->framesPerSecond;
            link.update = std::make_shared<const Prop>(std::move(*newer));
        }
        links.push_back(std::move(link));
    }
    return links;
}

DoodleScene withUpdatedProps(const DoodleScene &scene, const std::vector<PropLink> &links)
{
    DoodleScene updated = scene;
    for (const PropLink &link : links)
        for (Canvas &canvas : updated.canvases)
            if (link.update && canvas.prop && canvas.id == link.canvas && canvas.prop->link == link.link)
                canvas.prop = link.update;
    return updated;
}

} // namespace ductus
