#include "layerpainter/cli/open_painting.h"

#include "cli/batch_command.h"
#include "document/document_files.h"
#include "layerpainter/document/import_file.h"
#include "layerpainter/document/painting_project.h"
#include "project/project_reader.h"

namespace ductus {

Result<Painting> openPainting(const std::filesystem::path &path, const JobControl &control)
{
    if (hasExtension(path, ".ductus")) {
        const Result<Project> project = openProject(path, knownDocuments());
        if (!project)
            return project.error();
        if (const Result<StoredPainting> stored = paintingFromProject(*project); stored)
            return stored->content->painting();
    }
    Result<ImportedFile> imported = importFile(path, {}, control); // of projects: their surfaces
    if (!imported)
        return imported.error();
    return std::move(imported->painting);
}

} // namespace ductus
