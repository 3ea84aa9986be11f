#include "project/links/link_sources.h"

#include <algorithm>

namespace ductus {

namespace fs = std::filesystem;

LinkSources::LinkSources(const Project &own, fs::path ownFile, ProjectReadOptions options)
    : mOwn(own), mOwnFile(std::move(ownFile)), mOptions(std::move(options))
{
}

fs::path LinkSources::fileOf(const DocumentLink &link) const
{
    if (link.file.empty())
        return {};
    const fs::path file(link.file), folder = mOwnFile.parent_path();
    const fs::path whole = file.is_absolute() ? file : folder / file;
    std::error_code ignored;
    // Two projects that were moved together still find each other.
    if (const fs::path beside = folder / file.filename();
        !mOwnFile.empty() && !fs::exists(whole, ignored) && fs::exists(beside, ignored))
        return beside;
    return whole.lexically_normal();
}

Result<const ProjectDocument *> LinkSources::find(const DocumentLink &link, std::string_view kind)
{
    const std::string attempted = "Looking for changes of \"" + link.name + "\"";
    const fs::path file = fileOf(link);
    const Project *project = &mOwn;
    if (!file.empty()) {
        std::error_code ignored;
        if (!fs::exists(file, ignored))
            return Error{ErrorCode::FileNotFound, attempted, "its project is not where it was",
                         "Put it back, or go on with what was taken from it", file.string()};
        auto opened = mOpened.find(file);
        if (opened == mOpened.end())
            opened = mOpened.emplace(file, openProject(file, mOptions)).first;
        if (!opened->second)
            return opened->second.error();
        project = &*opened->second;
    }
    if (const ProjectDocument *document = project->find(link.document))
        return document;
    const auto isOfKind = [&](const ProjectDocument &document) { return document.kind == kind; };
    if (project != &mOwn && std::ranges::count_if(project->documents, isOfKind) == 1)
        return &*std::ranges::find_if(project->documents, isOfKind);
    return Error{ErrorCode::TooLittleData, attempted, "it is not in its project any more",
                 "Go on with what was taken from it", file.string()};
}

} // namespace ductus
