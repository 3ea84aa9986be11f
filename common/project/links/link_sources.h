// LinkSources: finds the documents links point to, opening each project once.
#pragma once

#include "project/links/document_link.h"
#include "project/project_reader.h"

#include <filesystem>
#include <map>

namespace ductus {

class LinkSources
{
public:
    /// \a own: the project that holds the links; must outlive this. \a ownFile: where it stands, empty if
    /// nowhere yet. \a options: which kinds of documents are read.
    LinkSources(const Project &own, std::filesystem::path ownFile, ProjectReadOptions options);

    /// The document as it is now; valid as long as this. A project another one was written over, as batch
    /// commands do, has other ids: there the only document of \a kind is taken for it. FileNotFound if the
    /// project is not where it was nor beside the own one, TooLittleData if it has the document no more, and
    /// the errors of openProject().
    Result<const ProjectDocument *> find(const DocumentLink &link, std::string_view kind);

    /// Where the project of \a link is looked for; empty: in the own one.
    std::filesystem::path fileOf(const DocumentLink &link) const;

private:
    const Project &mOwn;
    std::filesystem::path mOwnFile;
    ProjectReadOptions mOptions;
    std::map<std::filesystem::path, Result<Project>> mOpened;
};

} // namespace ductus
