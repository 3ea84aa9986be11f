#include "project/project.h"

#include <algorithm>

namespace ductus {

const ProjectDocument *Project::find(const Uuid &document) const
{
    const auto hasId = [&](const ProjectDocument &candidate) { return candidate.id == document; };
    const auto found = std::find_if(documents.begin(), documents.end(), hasId);
    return found == documents.end() ? nullptr : &*found;
}

ProjectDocument *Project::find(const Uuid &document)
{
    return const_cast<ProjectDocument *>(std::as_const(*this).find(document));
}

ProjectDocument newSketchSurface(const Uuid &id, std::string name, SketchSurfaceDocument content)
{
    ProjectDocument document;
    document.id = id;
    document.kind = sketchSurfaceKind;
    document.name = std::move(name);
    document.sketchSurface = std::make_shared<const SketchSurfaceDocument>(std::move(content));
    return document;
}

ProjectDocument newDocument(const Uuid &id, std::string name, std::shared_ptr<const DocumentContent> content)
{
    ProjectDocument document;
    document.id = id;
    document.kind = content->kind();
    document.name = std::move(name);
    document.content = std::move(content);
    return document;
}

Result<std::shared_ptr<const SketchSurfaceDocument>> sketchSurfaceOf(const ProjectDocument &document)
{
    if (document.sketchSurface)
        return document.sketchSurface;
    const std::string attempted = "Opening the document \"" + document.name + "\"";
    if (document.neededVersion > 0)
        return Error{ErrorCode::NewerVersion, attempted,
                     "it needs a version of Ductus that reads " + document.kind + " version " +
                         std::to_string(document.neededVersion),
                     "Install a newer version of Ductus", document.id.text()};
    return Error{ErrorCode::Unsupported, attempted, "it is of kind " + document.kind,
                 "Open it in the app it was made with", document.id.text()};
}

} // namespace ductus
