#include "layerpainter/document/import_file.h"

#include "base/error_place.h"
#include "formats/mesh_file.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/import/painting_import.h"
#include "painting/link/surface_link.h"
#include "painting/scene/painting_check.h"
#include "project/project_reader.h"

#include <algorithm>

namespace ductus {

namespace {

const Eigen::Vector3f clay(0.52f, 0.47f, 0.42f); // linear; light enough for shadows and highlights to show

std::string lowerExtension(const std::filesystem::path &path)
{
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

bool isPaintingFile(const std::filesystem::path &path)
{
    std::error_code ignored;
    const std::string extension = lowerExtension(path);
    return extension == ".quill" || extension == ".tilt" || extension == ".json" ||
           std::filesystem::is_directory(path, ignored);
}

std::string nameOf(const std::filesystem::path &path)
{
    const bool isQuillJson = path.filename() == "Quill.json" && path.has_parent_path();
    const std::filesystem::path named = isQuillJson ? path.parent_path() : path;
    const std::string name = named.stem().string();
    return name.empty() ? named.parent_path().filename().string() : name;
}

/// \a colours: linear RGB and opacity of the vertices; clay if there are none.
MeshShape meshShape(TriangleMesh mesh, const std::vector<Eigen::Vector4f> &colours)
{
    MeshShape shape{std::move(mesh), {}};
    shape.vertexColours.assign(shape.mesh.vertices.size(), clay);
    for (std::size_t v = 0; v < colours.size(); ++v)
        shape.vertexColours[v] = colours[v].head<3>();
    return shape;
}

Result<void> addMeshStack(Painting &painting, const std::string &name, MeshShape shape)
{
    const Result<AddedStack> stack = addStack(painting, name);
    if (!stack)
        return stack.error();
    Result<AddedElements> added = addElements(stack->painting, stack->substrate,
                                              {std::make_shared<const ElementShape>(std::move(shape))});
    if (!added)
        return added.error();
    painting = std::move(added->painting);
    return {};
}

Result<ImportedFile> importPaintingFile(const std::filesystem::path &path, const FileImportOptions &options,
                                        const JobControl &control)
{
    PaintingReadOptions reading;
    reading.firstFrameOnly = options.firstFrameOnly;
    const Result<PaintingFile> file = readPainting(path, reading, control.part(0.0, 0.8));
    if (!file)
        return file.error();
    control.progress(0.8, "Making stacks of the layers");
    Result<ImportedPainting> imported = importPainting(*file);
    if (!imported)
        return placedIn(imported.error(), path);
    if (imported->painting.stacks.empty())
        return Error{ErrorCode::TooLittleData, "Importing the painting", "no layer of it holds strokes",
                     "Choose a file with painted layers", path.string()};
    return ImportedFile{std::move(imported->painting),
                        file->kind == PaintingFileKind::Quill ? "quill" : "tilt", nameOf(path), file->report,
                        std::move(imported->notes)};
}

Result<ImportedFile> importMesh(const std::filesystem::path &path, const JobControl &control)
{
    Result<ColouredMesh> mesh = readColouredMesh(path, control);
    if (!mesh)
        return mesh.error();
    ImportedFile imported{{}, "mesh", nameOf(path), {}, {}};
    if (const Result<void> added = addMeshStack(imported.painting, imported.name,
                                                meshShape(std::move(mesh->mesh), mesh->vertexColours));
        !added)
        return placedIn(added.error(), path);
    if (mesh->vertexColours.empty())
        imported.notes.push_back("the mesh is clay-coloured: only GLB's colours of vertices and materials "
                                 "are read, no textures");
    else if (std::ranges::any_of(mesh->vertexColours, [](const auto &c) { return c.w() < 1.f; }))
        imported.notes.push_back("the mesh is opaque now: meshes have no opacity of their own");
    return imported;
}

Result<ImportedFile> importSurfacesOf(const std::filesystem::path &path, const FileImportOptions &options)
{
    const Result<Project> project = openProject(path);
    if (!project)
        return placedIn(project.error(), path);
    Result<ImportedFile> imported =
        importSurfaces(*project, nameOf(path), linkedFileName(path, options.seenFrom));
    return imported ? imported : placedIn(imported.error(), path);
}

} // namespace

Result<ImportedFile> importSurfaces(const Project &project, const std::string &name, const std::string &file)
{
    ImportedFile imported{{}, "sketch-surface", name, {}, {}};
    for (const ProjectDocument &document : project.documents) {
        if (!document.sketchSurface)
            continue;
        if (!document.sketchSurface->surface) {
            imported.notes.push_back("the sketch \"" + document.name + "\" has no finished surface");
            continue;
        }
        imported.painting.metresPerUnit = document.sketchSurface->strokes.metresPerUnit;
        if (const Result<void> added =
                addMeshStack(imported.painting, document.name.empty() ? name : document.name,
                             linkedSurface(document, file));
            !added)
            return added.error();
    }
    if (imported.painting.stacks.empty())
        return Error{ErrorCode::TooLittleData, "Importing the surface",
                     "the project holds no finished surface",
                     "Surface the sketch in SketchSurfacer and save it", ""};
    return imported;
}

Result<ImportedFile> importFile(const std::filesystem::path &path, const FileImportOptions &options,
                                const JobControl &control)
{
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        return Error{ErrorCode::FileNotFound, "Importing the painting", "there is no such file",
                     "Check the name", path.string()};
    if (lowerExtension(path) == ".ductus")
        return importSurfacesOf(path, options);
    return isPaintingFile(path) ? importPaintingFile(path, options, control) : importMesh(path, control);
}

} // namespace ductus
