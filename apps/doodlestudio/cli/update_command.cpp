#include "doodlestudio/cli/update_command.h"

#include "cli/batch_command.h"
#include "cli/project_output.h"
#include "doodlestudio/cli/open_doodle.h"
#include "doodling/prop/prop_link.h"
#include "project/project_reader.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

constexpr char updating[] = "Updating the paintings";

const char *stateOf(const PropLink &link)
{
    return link.update ? "changed" : link.problem ? "unknown" : "unchanged";
}

nlohmann::ordered_json reportOf(const std::vector<PropLink> &links, bool isUpdated)
{
    nlohmann::ordered_json report = {{"schema", "link-report"},
                                     {"version", 1},
                                     {"updated", isUpdated},
                                     {"links", nlohmann::json::array()}};
    for (const PropLink &link : links) {
        nlohmann::ordered_json one = {{"name", link.link.name},
                                      {"file", link.link.file},
                                      {"document", link.link.document.text()},
                                      {"canvas", link.canvas.value},
                                      {"state", stateOf(link)}};
        if (link.problem)
            one["problem"] = link.problem->message();
        report["links"].push_back(std::move(one));
    }
    return report;
}

std::string linesOf(const std::vector<PropLink> &links, bool isUpdated)
{
    if (links.empty())
        return "No painting stands in this scene.\n";
    std::string lines;
    for (const PropLink &link : links)
        lines += "\"" + link.link.name + "\"" + (link.link.file.empty() ? "" : " of " + link.link.file) +
                 ": " + stateOf(link) + (link.update && isUpdated ? ", updated" : "") +
                 (link.problem ? " (" + link.problem->problem + ")" : "") + "\n";
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
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The project to write; without it P.ductus itself."),
                                    QStringLiteral("OUT.ductus"));
    const QCommandLineOption check(QStringLiteral("check"),
                                   QStringLiteral("Only says what has changed and writes nothing."));
    const QCommandLineOption json(QStringLiteral("json"), QStringLiteral("Says it as JSON."));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project with the filmed scene."));
    for (const QCommandLineOption &option : {output, check, json})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::filesystem::path input = parser.positionalPath(0);
    const std::filesystem::path target = parser.isSet(output) ? parser.path(output) : input;
    if (!hasExtension(target, ".ductus"))
        return parser.wrongUsage(QStringLiteral("the project must end in .ductus"));
    TerminalJob job(parser.isQuiet());
    const Result<OpenedDoodle> doodle = openDoodle(input);
    if (!doodle)
        return failed(job, doodle.error());
    const DoodleContent &content = *doodle->content;
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    LinkSources sources(doodle->project, std::filesystem::absolute(input), options);
    const std::vector<PropLink> links = propLinks(*content.scene(), sources);
    const bool updates = !parser.isSet(check) && std::ranges::any_of(links, [](const PropLink &link) {
        return link.update != nullptr;
    });
    if (updates || (parser.isSet(output) && !parser.isSet(check))) {
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
    const std::string text =
        parser.isSet(json) ? reportOf(links, updates).dump(2) + "\n" : linesOf(links, updates);
    std::fputs(text.c_str(), stdout);
    return ExitCode::Done;
}

} // namespace ductus
