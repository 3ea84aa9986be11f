#include "layerpainter/cli/update_command.h"

#include "base/error_place.h"
#include "cli/link_report.h"
#include "cli/project_output.h"
#include "document/document_files.h"
#include "layerpainter/document/painting_project.h"
#include "painting/action/action.h"
#include "painting/link/surface_link.h"

namespace ductus {

namespace {

constexpr char updating[] = "Updating the surfaces";

struct UpdateArguments
{
    std::filesystem::path input, output;
    bool checksOnly = false;
    bool asJson = false;
};

std::vector<LinkLine> linesOf(const std::vector<SurfaceLink> &links)
{
    std::vector<LinkLine> lines;
    for (const SurfaceLink &link : links)
        lines.push_back({link.link, link.isOutdated(), link.problem, "elements", int(link.elements.size())});
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
    printLinks(linesOf(links), updates, a.asJson, "No surface is linked to a sketch.");
    return ExitCode::Done;
}

} // namespace

ExitCode runUpdateCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("update"),
        QStringLiteral("Looks whether the sketches a painting's surfaces were made from have changed and "
                       "takes the new surfaces. Layers, strokes, masks and looks stay as they are."));
    const UpdateOptions options;
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project with the painting."));
    options.addTo(parser);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const UpdateArguments a{parser.positionalPath(0), parser.path(options.output),
                            parser.isSet(options.check), parser.isSet(options.json)};
    if (!a.output.empty() && !hasExtension(a.output, ".ductus"))
        return parser.wrongUsage(QStringLiteral("the project must end in .ductus"));
    TerminalJob job(parser.isQuiet());
    return run(a, job);
}

} // namespace ductus
