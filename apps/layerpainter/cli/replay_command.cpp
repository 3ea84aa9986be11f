#include "layerpainter/cli/replay_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "formats/atomic_file.h"
#include "layerpainter/cli/open_painting.h"
#include "layerpainter/cli/painting_report.h"
#include "layerpainter/document/painting_project.h"
#include "painting/action/action_log.h"
#include "project/project_writer.h"

#include <cstdio>

namespace ductus {

namespace {

constexpr char writing[] = "Writing the project";
constexpr std::uint64_t maxLogBytes = 1ull << 30;

struct ReplayArguments
{
    std::filesystem::path log;
    std::filesystem::path output;
    std::filesystem::path start; // instead of what the log names
    std::size_t steps = 0;       // 0: all
};

Result<Painting> play(const ReplayArguments &a, const JobControl &control)
{
    const Result<std::string> text = readWholeFile(a.log, maxLogBytes, "Reading the action log");
    if (!text)
        return text.error();
    const std::string name = a.log.filename().string();
    const Result<std::vector<LogEntry>> log = parsedLog(*text, name);
    if (!log)
        return log.error();
    const auto open = [&](const std::string &source) {
        return openPainting(a.start.empty() ? a.log.parent_path() / source : a.start, control);
    };
    const auto goesOn = [&](std::size_t entry, const Painting &) {
        return a.steps == 0 || entry + 1 < a.steps;
    };
    return replayed(*log, name, open, control.part(0.1, 0.9), goesOn);
}

ExitCode run(const ReplayArguments &a, bool quiet, TerminalJob &job)
{
    const JobControl control = job.control();
    if (Result<void> writable = checkWritable(a.output, writing); !writable)
        return failed(job, writable.error());
    const Result<Painting> painting = play(a, control);
    if (!painting)
        return failed(job, painting.error());
    control.progress(0.9, writing);
    const Result<SerializedProject> project = serializedProject(projectOf(*painting, a.log.stem().string()));
    if (!project)
        return failed(job, project.error());
    OutputFiles files;
    Result<void> written = files.add(a.output, project->bytes, writing);
    if (written && control.isCancelled())
        written = cancelledError(writing);
    if (written)
        written = files.commit();
    if (!written)
        return failed(job, written.error());
    control.progress(1.0, "Done");
    job.finishLine();
    const std::string lines = paintingLines(*painting);
    if (!quiet)
        std::fprintf(stderr, "%s: %s", a.output.string().c_str(),
                     lines.substr(0, lines.find('\n') + 1).c_str());
    return ExitCode::Done;
}

} // namespace

ExitCode runReplayCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("replay"),
        QStringLiteral("Plays an action log (File > Save action log), or a script of actions, and writes "
                       "the painting. The same log gives the same bytes. The manual describes every "
                       "action."));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The project to write."), QStringLiteral("P.ductus"));
    const QCommandLineOption start(
        QStringLiteral("start"),
        QStringLiteral("The painting to start from, instead of the file the log names."),
        QStringLiteral("FILE"));
    const QCommandLineOption steps(QStringLiteral("steps"), QStringLiteral("Plays only the first N lines."),
                                   QStringLiteral("N"));
    parser.addPositional(QStringLiteral("LOG.jsonl"),
                         QStringLiteral("The log, a line of JSON for each action."));
    for (const QCommandLineOption &option : {output, start, steps})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    ReplayArguments a{parser.positionalPath(0), parser.path(output), parser.path(start)};
    if (a.output.empty())
        return parser.wrongUsage(QStringLiteral("-o P.ductus is missing"));
    if (!hasExtension(a.output, ".ductus"))
        return parser.wrongUsage(QStringLiteral("the project must end in .ductus"));
    if (parser.isSet(steps)) {
        bool isNumber = false;
        a.steps = parser.value(steps).toUInt(&isNumber);
        if (!isNumber || a.steps == 0)
            return parser.wrongUsage(QStringLiteral("--steps takes a whole number from 1"));
    }
    TerminalJob job(parser.isQuiet());
    return run(a, parser.isQuiet(), job);
}

} // namespace ductus
