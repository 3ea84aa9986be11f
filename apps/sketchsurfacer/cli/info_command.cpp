#include "sketchsurfacer/cli/info_command.h"

#include "base/error_place.h"
#include "cli/batch_command.h"
#include "document/document_files.h"
#include "formats/mesh_file.h"
#include "project/project_reader.h"
#include "sketchsurfacer/cli/print_report.h"
#include "sketchsurfacer/cli/sketch_input.h"

#include <cstdio>

namespace ductus {

namespace {

using Json = nlohmann::ordered_json;

struct Told
{
    Json json;
    std::string text;
};

Result<void> tellMesh(const TriangleMesh &mesh, double metresPerUnit, const JobControl &control, Json &entry,
                      std::string &text)
{
    const Result<PrintCheck> check = checkForPrint(mesh, control);
    if (!check)
        return check.error();
    entry["vertices"] = mesh.vertexCount();
    entry["triangles"] = mesh.triangleCount();
    entry["print"] = printReport(*check, metresPerUnit);
    text += printLines(*check, metresPerUnit);
    return {};
}

Result<Told> tellProject(const std::filesystem::path &path, const JobControl &control)
{
    const Result<Project> project = openProject(path, knownDocuments());
    if (!project)
        return placedIn(project.error(), path);
    Told told;
    told.json = {{"schema", "project-info"},
                 {"version", 1},
                 {"id", project->id.text()},
                 {"generator", project->generator}};
    told.text = path.filename().string() + ", made by " + project->generator + "\n";
    told.json["documents"] = Json::array();
    for (const ProjectDocument &document : project->documents) {
        Json entry = {{"id", document.id.text()}, {"kind", document.kind}, {"name", document.name}};
        told.text += document.kind + " \"" + document.name + "\"";
        if (document.sketchSurface) {
            const SketchSurfaceDocument &sketch = *document.sketchSurface;
            entry["strokes"] = sketch.strokes.strokes.size();
            entry["points"] = sketch.strokes.pointCount();
            entry["metresPerUnit"] = sketch.strokes.metresPerUnit;
            entry["surface"] = nullptr;
            told.text += ": " + std::to_string(sketch.strokes.strokes.size()) + " strokes, " +
                         (sketch.surface ? std::to_string(sketch.surface->mesh.triangleCount()) + " triangles"
                                         : std::string("not surfaced"));
        }
        told.text += "\n";
        if (document.sketchSurface && document.sketchSurface->surface) {
            Json surface;
            if (Result<void> done =
                    tellMesh(document.sketchSurface->surface->mesh,
                             document.sketchSurface->strokes.metresPerUnit, control, surface, told.text);
                !done)
                return done.error();
            entry["surface"] = std::move(surface);
        }
        told.json["documents"].push_back(std::move(entry));
    }
    told.json["warnings"] = project->warnings;
    for (const std::string &warning : project->warnings)
        told.text += warning + "\n";
    return told;
}

Result<Told> tellMeshFile(const std::filesystem::path &path, double metresPerUnit, const JobControl &control)
{
    const Result<TriangleMesh> mesh = readMesh(path, control);
    if (!mesh)
        return mesh.error();
    Told told;
    told.json = {{"schema", "mesh-info"}, {"version", 1}};
    told.text = path.filename().string() + ": " + std::to_string(mesh->triangleCount()) + " triangles\n";
    if (Result<void> done = tellMesh(*mesh, metresPerUnit, control, told.json, told.text); !done)
        return done.error();
    return told;
}

} // namespace

ExitCode runInfoCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("info"),
        QStringLiteral("Says what a project or a mesh holds: size, watertight or not, thinnest "
                       "wall, narrowest gap, where it runs through itself.\n\n"
                       "FILE: a .ductus, or OBJ, PLY, STL, OFF, GLB."));
    const QCommandLineOption json(QStringLiteral("json"), QStringLiteral("As JSON."));
    const QCommandLineOption unit(
        QStringLiteral("unit"), QStringLiteral("What 1 means in a mesh file: m, cm, mm or in (default: m)."),
        QStringLiteral("UNIT"), QStringLiteral("m"));
    parser.addPositional(QStringLiteral("FILE"), QStringLiteral("The project or mesh."));
    parser.addOption(json);
    parser.addOption(unit);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::pair<const char *, double> units[] = {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}};
    double metresPerUnit = 0.0;
    for (const auto &[name, metres] : units)
        if (parser.value(unit) == QLatin1String(name))
            metresPerUnit = metres;
    if (metresPerUnit == 0.0)
        return parser.wrongUsage(QStringLiteral("--unit must be m, cm, mm or in"));
    TerminalJob job(true);
    const std::filesystem::path path = parser.positionalPath(0);
    const Result<Told> told = isProjectExtension(path) ? tellProject(path, job.control())
                                                       : tellMeshFile(path, metresPerUnit, job.control());
    if (!told)
        return failed(job, told.error());
    std::fputs(parser.isSet(json) ? (told->json.dump(2) + "\n").c_str() : told->text.c_str(), stdout);
    return ExitCode::Done;
}

} // namespace ductus
