#include "doodlestudio/cli/update_command.h"

#include "cli/link_report.h"
#include "cli/project_output.h"
#include "doodlestudio/cli/open_doodle.h"
#include "doodling/prop/prop_link.h"
#include "project/project_reader.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr char updating[] = "Updating the paintings";

std::vector<LinkLine> linesOf(const std::vector<PropLink> &links)
{
    std::vector<LinkLine> lines;
    for (const PropLink &link : links)
        lines.push_back({link.link, link.update != nullptr, link.problem, "canvas", int(link.canvas.value)});
    return lines;
}

} // namespace

ExitCode runUpdatePropsCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("update"),
        QStringLiteral(
            "Looks whether the paintings that stand in a filmed scene have changed and takes them as "
            "they are now. Where they stand and their look stay."));
    const UpdateOptions options;
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project with the filmed scene."));
    options.addTo(parser);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::filesystem::path input = parser.positionalPath(0);
    const std::filesystem::path target = parser.isSet(options.output) ? parser.path(options.output) : input;
    if (!hasExtension(target, ".ductus"))
        return parser.wrongUsage(QStringLiteral("the project must end in .ductus"));
    TerminalJob job(parser.isQuiet());
    const Result<OpenedDoodle> doodle = openDoodle(input);
    if (!doodle)
        return failed(job, doodle.error());
    const DoodleContent &content = *doodle->content;
    ProjectReadOptions paintings;
    paintings.kinds = {paintingKind()};
    LinkSources sources(doodle->project, std::filesystem::absolute(input), paintings);
    const std::vector<PropLink> links = propLinks(*content.scene(), sources);
    const bool updates = !parser.isSet(options.check) && std::ranges::any_of(links, [](const PropLink &link) {
        return link.update != nullptr;
    });
    if (updates || (parser.isSet(options.output) && !parser.isSet(options.check))) {
        Project changed = doodle->project;
        if (updates)
            for (ProjectDocument &document : changed.documents)
                if (document.content == doodle->content)
                    document.content = std::make_shared<const DoodleContent>(
                        content.clip(), content.shot(), content.unknown(),
                        std::make_shared<const DoodleScene>(withUpdatedProps(*content.scene(), links)),
                        content.packsAnalysis());
        if (Result<void> saved = saveProjectFile(changed, target, updating); !saved)
            return failed(job, saved.error());
    }
    job.finishLine();
    printLinks(linesOf(links), updates, parser.isSet(options.json), "No painting stands in this scene.");
    return ExitCode::Done;
}

} // namespace ductus
