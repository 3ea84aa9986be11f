#include "doodlestudio/cli/export_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "doodlestudio/cli/timeline_file.h"
#include "doodlestudio/cli/whole_shot.h"
#include "doodling/export/export_film.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

struct ExportArguments
{
    std::filesystem::path project, output, clip, otio;
    FilmExport what;
    bool wantsJson = false;
};

void tell(const ExportReport &report, const ExportArguments &a)
{
    if (!a.wantsJson)
        return;
    const nlohmann::ordered_json json = {{"schema", "film-export-report"},
                                         {"version", 1},
                                         {"output", a.output.string()},
                                         {"frames", report.frames},
                                         {"width", report.width},
                                         {"height", report.height},
                                         {"rate", {report.rate.numerator, report.rate.denominator}},
                                         {"evenRate", report.hasEvenRate},
                                         {"sound", report.hasSound},
                                         {"warnings", report.warnings}};
    std::fputs((json.dump(2) + "\n").c_str(), stdout);
}

ExitCode run(const ExportArguments &a, TerminalJob &job)
{
    const JobControl control = job.control();
    control.progress(0.0, "Opening the project");
    const Result<OpenedDoodle> doodle = openDoodle(a.project);
    if (!doodle)
        return failed(job, doodle.error());
    if (!a.otio.empty()) {
        if (const Result<void> written = writeTimelineFile(*doodle, a.clip, a.otio); !written)
            return failed(job, written.error());
        if (a.output.empty()) {
            job.finishLine();
            return ExitCode::Done;
        }
    }
    const std::filesystem::path &clipPath = a.clip.empty() ? doodle->clip : a.clip;
    if (isSameFile(a.output, clipPath))
        return failed(job, {ErrorCode::InvalidArgument, "Exporting the film", "it would replace the clip",
                            "Choose another name", a.output.string()});
    Result<std::unique_ptr<Clip>> clip = openItsClip(*doodle, a.clip, control.part(0.0, 0.05));
    if (!clip)
        return failed(job, clip.error());
    const Result<std::shared_ptr<const Shot>> shot = wholeShot(*doodle, a.clip, control.part(0.05, 0.1));
    if (!shot)
        return failed(job, shot.error());
    const Result<ExportReport> report = exportFilm(**clip, clipPath, **shot, *doodle->content->scene(),
                                                   a.what, a.output, control.part(0.1, 1.0));
    if (!report)
        return failed(job, report.error());
    job.finishLine();
    for (const std::string &warning : report->warnings)
        std::fprintf(stderr, "doodlestudio: %s\n", warning.c_str());
    tell(*report, a);
    return ExitCode::Done;
}

constexpr std::pair<const char *, ExportContent> contents[] = {{"composite", ExportContent::Composite},
                                                               {"doodle", ExportContent::Doodle},
                                                               {"depth", ExportContent::Depth}};

} // namespace

ExitCode runExportCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("export"),
        QStringLiteral("Writes the clip with its doodles as a film: every frame, at the clip's size "
                       "and rate, with its sound.\n\nP.ductus: made by `doodlestudio analyse` and drawn "
                       "on."));
    const QCommandLineOption output(
        {QStringLiteral("o"), QStringLiteral("output")},
        QStringLiteral("OUT.mp4 (H.264), OUT.webm (VP9), OUT.gif, or a folder for "
                       "numbered PNGs."),
        QStringLiteral("OUT"));
    const QCommandLineOption what(
        QStringLiteral("what"),
        QStringLiteral("composite (default), doodle (alone, transparent but in MP4) or "
                       "depth (near is light)."),
        QStringLiteral("WHAT"), QStringLiteral("composite"));
    const QCommandLineOption lines(QStringLiteral("lines"),
                                   QStringLiteral("At most so many lines. Default: the clip's."),
                                   QStringLiteral("N"));
    const QCommandLineOption every(QStringLiteral("every"),
                                   QStringLiteral("Only every Nth frame, as for a small GIF. Default: 1."),
                                   QStringLiteral("N"), QStringLiteral("1"));
    const QCommandLineOption silent(QStringLiteral("silent"), QStringLiteral("Without the clip's sound."));
    const QCommandLineOption clip(QStringLiteral("clip"),
                                  QStringLiteral("Where the clip is now, if it was moved."),
                                  QStringLiteral("CLIP"));
    const QCommandLineOption otio(QStringLiteral("otio"),
                                  QStringLiteral("Also, or without -o only, a timeline for editing programs "
                                                 "(OpenTimelineIO): the clip, the canvases above it, their "
                                                 "keyframes as markers."),
                                  QStringLiteral("FILE.otio"));
    const QCommandLineOption json(QStringLiteral("json"), QStringLiteral("A report on standard output."));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    for (const QCommandLineOption &option : {output, what, lines, every, silent, clip, otio, json})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    ExportArguments a;
    a.project = parser.positionalPath(0);
    a.output = parser.path(output);
    a.clip = parser.path(clip);
    a.otio = parser.path(otio);
    a.wantsJson = parser.isSet(json);
    a.what.withSound = !parser.isSet(silent);
    const std::optional<FilmKind> kind = filmKindOf(a.output);
    if (!kind && (a.otio.empty() || parser.isSet(output)))
        return parser.wrongUsage(QStringLiteral("-o OUT.mp4, OUT.webm, OUT.gif or a folder is missing"));
    a.what.kind = kind.value_or(FilmKind::Mp4);
    bool isKnown = false;
    for (const auto &[name, content] : contents)
        if (parser.value(what) == QLatin1String(name)) {
            a.what.content = content;
            isKnown = true;
        }
    if (!isKnown)
        return parser.wrongUsage(QStringLiteral("--what takes composite, doodle or depth"));
    bool isCount = true, isStep = false;
    if (parser.isSet(lines))
        a.what.mostLines = parser.value(lines).toInt(&isCount);
    a.what.everyNth = parser.value(every).toInt(&isStep);
    if (!isCount || (parser.isSet(lines) && (a.what.mostLines < 2 || a.what.mostLines > 16384)))
        return parser.wrongUsage(QStringLiteral("--lines takes a whole number from 2 to 16384"));
    if (!isStep || a.what.everyNth < 1)
        return parser.wrongUsage(QStringLiteral("--every takes a whole number from 1"));
    TerminalJob job(parser.isQuiet());
    return run(a, job);
}

} // namespace ductus
