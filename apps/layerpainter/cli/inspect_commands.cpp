#include "layerpainter/cli/inspect_commands.h"

#include "base/error_place.h"
#include "cli/batch_command.h"
#include "document/document_files.h"
#include "formats/atomic_file.h"
#include "layerpainter/cli/painting_report.h"
#include "painting/storage/painting_content.h"
#include "project/project_reader.h"
#include "project/schema_check.h"

#include <cstdio>

namespace ductus {

ExitCode runInfoCommand(const QStringList &arguments)
{
    BatchParser parser(QStringLiteral("info"), QStringLiteral("Says what a project holds."));
    const QCommandLineOption json(QStringLiteral("json"), QStringLiteral("As JSON."));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    parser.addOption(json);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    TerminalJob job(true);
    const std::filesystem::path path = parser.positionalPath(0);
    const Result<Project> project = openProject(path, knownDocuments());
    if (!project)
        return failed(job, placedIn(project.error(), path));
    nlohmann::ordered_json report = {{"schema", "project-info"},
                                     {"version", 1},
                                     {"id", project->id.text()},
                                     {"generator", project->generator}};
    report["documents"] = nlohmann::ordered_json::array();
    std::string text = path.filename().string() + ", made by " + project->generator + "\n";
    for (const ProjectDocument &document : project->documents) {
        nlohmann::ordered_json entry = {
            {"id", document.id.text()}, {"kind", document.kind}, {"name", document.name}};
        text += document.kind + " \"" + document.name + "\"";
        if (const auto content = paintingOf(document); content) {
            entry["painting"] = paintingSummary((*content)->painting());
            text += ": " + paintingLines((*content)->painting());
        } else {
            text += "\n";
        }
        report["documents"].push_back(std::move(entry));
    }
    report["warnings"] = project->warnings;
    for (const std::string &warning : project->warnings)
        text += warning + "\n";
    std::fputs(parser.isSet(json) ? (report.dump(2) + "\n").c_str() : text.c_str(), stdout);
    return ExitCode::Done;
}

ExitCode runValidateCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("validate"),
        QStringLiteral("Checks a project: container, hashes, schemas, and that everything in it is "
                       "sound. Silent if all is well."));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    TerminalJob job(true);
    const std::filesystem::path path = parser.positionalPath(0);
    const Result<std::string> bytes =
        readWholeFile(path, ContainerLimits().maxFileBytes, "Checking the project");
    if (!bytes)
        return failed(job, bytes.error());
    const std::string name = path.filename().string();
    const Result<std::vector<std::string>> violations = projectSchemaViolations(asBytes(*bytes), name);
    if (!violations)
        return failed(job, violations.error());
    for (const std::string &line : *violations)
        std::fprintf(stderr, "layerpainter: %s: %s\n", name.c_str(), line.c_str());
    const Result<Project> project = parseProject(asBytes(*bytes), name, knownDocuments());
    if (!project)
        return failed(job, project.error());
    for (const std::string &warning : project->warnings)
        std::fprintf(stderr, "layerpainter: %s: %s\n", name.c_str(), warning.c_str());
    return violations->empty() ? ExitCode::Done : ExitCode::Failed;
}

} // namespace ductus
