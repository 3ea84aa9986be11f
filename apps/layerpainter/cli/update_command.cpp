#include "layerpainter/cli/update_command.h"

#include "base/error_place.h"
#include "cli/batch_command.h"
#include "cli/project_output.h"
#include "document/document_files.h"
#include "layerpainter/document/painting_project.h"
#include "painting/action/action.h"
#include "painting/link/surface_link.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

constexpr char updating[] = "Updating the surfaces";

struct UpdateArguments
{
    std::filesystem::path input, output;
    bool checksOnly = false;
    bool asJson = false;
};

const char *stateOf(const SurfaceLink &link)
{
    return link.isOutdated() ? "changed" : link.problem ? "unknown" : "unchanged";
}

nlohmann::ordered_json reportOf(const std::vector<SurfaceLink> &links, bool isUpdated)
{
    nlohmann::ordered_json report = {{"schema", "link-report"},
                                     {"version", 1},
                                     {"updated", isUpdated},
                                     {"links", nlohmann::json::array()}};
    for (const SurfaceLink &link : links) {
        nlohmann::ordered_json one = {{"name", link.link.name},
                                      {"file", link.link.file},
                                      {"document", link.link.document.text()},
                                      {"elements", link.elements.size()},
                                      {"state", stateOf(link)}};
        if (link.problem)
            one["problem"] = link.problem->message();
        report["links"].push_back(std::move(one));
    }
    return report;
}

std::string linesOf(const std::vector<SurfaceLink> &links, bool isUpdated)
{
    if (links.empty())
        return "No surface is linked to a sketch.\n";
    std::string lines;
    for (const SurfaceLink &link : links) {
        lines += "\"" + link.link.name + "\"" + (link.link.file.empty() ? "" : " of " + link.link.file) +
                 ": " + stateOf(link) + (link.isOutdated() && isUpdated ? ", updated" : "");
        lines += (link.problem ? " (" + link.problem->problem + ")" : "") + "\n";
    }
    return lines;
}

ExitCode run(const UpdateArguments &a, TerminalJob &job)
{
    Result<Project> project = openProject(a.input, knownDocuments());
    if (!project)
        return failed(job, placedIn(project.error(), a.input));
    const Result<StoredPainting> stored = paintingFromProject(*project);
    if (!stored)
        return failed(job, placedIn(stored.error(), a.input));
    LinkSources sources(*project, std::filesystem::absolute(a.input), {});
    const std::vector<SurfaceLink> links = surfaceLinks(stored->content->painting(), sources);
    act::ReplaceShape update;
    for (const SurfaceLink &link : links) {
        update.elements.insert(update.elements.end(), link.outdated.begin(), link.outdated.end());
        update.strokes.insert(update.strokes.end(), link.updates.begin(), link.updates.end());
    }
    const std::filesystem::path output = a.output.empty() ? a.input : a.output;
    const bool updates = !a.checksOnly && !update.elements.empty();
    if (updates) {
        const Result<PerformedAction> updated = performed(stored->content->painting(), update);
        if (!updated)
            return failed(job, placedIn(updated.error(), a.input));
        Project changed = *project;
        putPainting(std::make_shared<const PaintingContent>(updated->painting, stored->content->unknown()),
                    stored->documentId, stored->name, changed);
        if (Result<void> written = saveProjectFile(changed, output, updating); !written)
            return failed(job, written.error());
    } else if (!a.output.empty() && !a.checksOnly) {
        if (Result<void> written = saveProjectFile(*project, output, updating); !written)
            return failed(job, written.error());
    }
    job.finishLine();
    const std::string text = a.asJson ? reportOf(links, updates).dump(2) + "\n" : linesOf(links, updates);
    std::fputs(text.c_str(), stdout);
    return ExitCode::Done;
}

} // namespace

ExitCode runUpdateCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("update"),
        QStringLiteral("Looks whether the sketches a painting's surfaces were made from have changed and "
                       "takes the new surfaces. Layers, strokes, masks and looks stay as they are."));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The project to write; without it P.ductus itself."),
                                    QStringLiteral("OUT.ductus"));
    const QCommandLineOption check(QStringLiteral("check"),
                                   QStringLiteral("Only says what has changed and writes nothing."));
    const QCommandLineOption json(QStringLiteral("json"), QStringLiteral("Says it as JSON."));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project with the painting."));
    for (const QCommandLineOption &option : {output, check, json})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const UpdateArguments a{parser.positionalPath(0), parser.path(output), parser.isSet(check),
                            parser.isSet(json)};
    if (!a.output.empty() && !hasExtension(a.output, ".ductus"))
        return parser.wrongUsage(QStringLiteral("the project must end in .ductus"));
    TerminalJob job(parser.isQuiet());
    return run(a, job);
}

} // namespace ductus
