#include "layerpainter/cli/import_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "layerpainter/cli/painting_report.h"
#include "layerpainter/document/painting_project.h"
#include "project/project_writer.h"

#include <cstdio>
#include <new>
#include <span>

namespace ductus {

namespace {

constexpr char writingProject[] = "Writing the project";
constexpr char writingReport[] = "Writing the report";

struct ImportArguments
{
    std::filesystem::path input;
    std::filesystem::path output;
    std::filesystem::path report;
    FileImportOptions options;
    bool quiet = false;
};

// What can be known to fail after the work is better told before it.
Result<void> checkOutputs(const ImportArguments &a)
{
    for (const auto &[path, attempted] :
         {std::pair(&a.output, writingProject), std::pair(&a.report, writingReport)}) {
        if (path->empty())
            continue;
        if (Result<void> writable = checkWritable(*path, attempted); !writable)
            return writable;
        if (isSameFile(*path, a.input))
            return Error{ErrorCode::InvalidArgument, attempted,
                         "this file is also read; it would be overwritten", "Choose another name",
                         path->string()};
    }
    return {};
}

Result<void> writeOutputs(const ImportArguments &a, const ImportedFile &imported, const JobControl &control)
{
    OutputFiles files;
    if (!a.report.empty()) {
        const std::string text = importReport(a.input.string(), imported).dump(2) + "\n";
        if (Result<void> added = files.add(a.report, std::as_bytes(std::span(text)), writingReport); !added)
            return added;
    }
    const Result<SerializedProject> project = serializedProject(projectOf(imported.painting, imported.name));
    if (!project)
        return project.error();
    if (Result<void> added = files.add(a.output, project->bytes, writingProject); !added)
        return added;
    if (control.isCancelled())
        return cancelledError(writingProject);
    return files.commit();
}

ExitCode run(const ImportArguments &a, TerminalJob &job)
{
    const JobControl control = job.control();
    if (Result<void> writable = checkOutputs(a); !writable)
        return failed(job, writable.error());
    control.progress(0.0, "Reading the file");
    FileImportOptions options = a.options;
    options.seenFrom = std::filesystem::absolute(a.output).parent_path();
    const Result<ImportedFile> imported = importFile(a.input, options, control.part(0.0, 0.8));
    if (!imported)
        return failed(job, imported.error());
    control.progress(0.8, "Writing the project");
    if (Result<void> written = writeOutputs(a, *imported, control.part(0.8, 1.0)); !written)
        return failed(job, written.error());
    control.progress(1.0, "Done");
    job.finishLine();
    for (const std::string &line : imported->report.skipped)
        std::fprintf(stderr, "layerpainter: skipped: %s\n", line.c_str());
    if (!a.quiet)
        std::fprintf(stderr, "%s: %s", a.output.string().c_str(),
                     paintingLines(imported->painting)
                         .substr(0, paintingLines(imported->painting).find('\n') + 1)
                         .c_str());
    return ExitCode::Done;
}

} // namespace

ExitCode runImportCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("import"),
        QStringLiteral("Imports a painting or a mesh into a project, its strokes still strokes.\n\n"
                       "IN: a Quill folder or .quill, a .tilt, OBJ, PLY, STL, OFF, GLB, or a .ductus "
                       "with surfaces of SketchSurfacer."));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The project to write."), QStringLiteral("P.ductus"));
    const QCommandLineOption report(QStringLiteral("report"),
                                    QStringLiteral("Writes what was read and what was skipped as JSON."),
                                    QStringLiteral("R.json"));
    const QCommandLineOption firstFrame(QStringLiteral("first-frame"),
                                        QStringLiteral("Only the first frame of frame-by-frame layers."));
    parser.addPositional(QStringLiteral("IN"), QStringLiteral("The painting or mesh."));
    for (const QCommandLineOption &option : {output, report, firstFrame})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    ImportArguments a{parser.positionalPath(0),
                      parser.path(output),
                      parser.path(report),
                      {parser.isSet(firstFrame)},
                      parser.isQuiet()};
    if (a.output.empty())
        return parser.wrongUsage(QStringLiteral("-o P.ductus is missing"));
    if (!hasExtension(a.output, ".ductus"))
        return parser.wrongUsage(QStringLiteral("the project must end in .ductus"));
    if (!a.report.empty() && isSameFile(a.output, a.report))
        return parser.wrongUsage(QStringLiteral("-o and --report name the same file"));
    TerminalJob job(a.quiet);
    try {
        return run(a, job);
    } catch (const std::bad_alloc &) {
        return failed(job, {ErrorCode::TooLarge, "Importing the painting",
                            "the memory does not suffice for it", "Import fewer layers", a.input.string()});
    }
}

} // namespace ductus
