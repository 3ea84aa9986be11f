#include "layerpainter/cli/export_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "layerpainter/cli/look_argument.h"
#include "layerpainter/cli/open_painting.h"
#include "layerpainter/document/export_mesh.h"

#include <cmath>
#include <cstdio>
#include <new>
#include <span>

namespace ductus {

namespace {

constexpr char writing[] = "Writing the mesh";

struct ExportArguments
{
    std::filesystem::path input;
    std::filesystem::path output;
    QString look;
    MeshExportOptions options;
    bool quiet = false;
};

ExitCode run(ExportArguments a, TerminalJob &job)
{
    const JobControl control = job.control();
    Result<void> writable = checkWritable(a.output, writing);
    if (writable && isSameFile(a.output, a.input))
        writable =
            Error{ErrorCode::InvalidArgument, writing, "this file is also read; it would be overwritten",
                  "Choose another name", a.output.string()};
    if (!writable)
        return failed(job, writable.error());
    const Result<Painting> painting = openPainting(a.input, control.part(0, 0.1));
    if (!painting)
        return failed(job, painting.error());
    const Result<std::optional<LookId>> look = lookNamed(*painting, a.look);
    if (!look)
        return failed(job, look.error());
    a.options.moment.look = *look;
    const Result<ExportedMesh> mesh = exportedMesh(*painting, a.options, control.part(0.1, 0.95));
    if (!mesh)
        return failed(job, mesh.error());
    OutputFiles files;
    Result<void> written = files.add(a.output, std::as_bytes(std::span(mesh->bytes)), writing);
    if (written && control.isCancelled())
        written = cancelledError(writing);
    if (written)
        written = files.commit();
    if (!written)
        return failed(job, written.error());
    control.progress(1.0, "Done");
    job.finishLine();
    if (!a.quiet)
        std::fprintf(stderr, "%s: %d stacks, %lld vertices, %lld triangles, edges up to %.4g units\n",
                     a.output.string().c_str(), mesh->stacks, static_cast<long long>(mesh->vertices),
                     static_cast<long long>(mesh->triangles), mesh->edgeLength);
    return ExitCode::Done;
}

} // namespace

ExitCode runExportCommand(const QStringList &arguments)
{
    BatchParser parser(QStringLiteral("export"),
                       QStringLiteral("Writes a painting as a mesh with one node a stack: strokes become "
                                      "tubes, what the layers do becomes colours of vertices, unlit.\n\n"
                                      "P: a project, or anything import reads."));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The mesh to write."), QStringLiteral("X.glb"));
    const QCommandLineOption look(QStringLiteral("look"), QStringLiteral("The look to show, by its name."),
                                  QStringLiteral("NAME"));
    const QCommandLineOption edge(
        QStringLiteral("edge"),
        QStringLiteral("The longest edge of a triangle, scene units: shorter shows finer colours. Default: "
                       "a 600th of the painting, longer if it would be more than 1.5 million vertices."),
        QStringLiteral("LENGTH"));
    const QCommandLineOption time(QStringLiteral("time"), QStringLiteral("Second of the motion. Default: 0."),
                                  QStringLiteral("S"), QStringLiteral("0"));
    parser.addPositional(QStringLiteral("P"), QStringLiteral("The painting."));
    for (const QCommandLineOption &option : {output, look, edge, time})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    ExportArguments a;
    a.input = parser.positionalPath(0);
    a.output = parser.path(output);
    a.look = parser.value(look);
    a.quiet = parser.isQuiet();
    if (a.output.empty() || !hasExtension(a.output, ".glb"))
        return parser.wrongUsage(QStringLiteral("-o X.glb is missing"));
    bool isTime = false, isEdge = true;
    a.options.moment.timeSeconds = parser.value(time).toDouble(&isTime);
    if (!isTime || !std::isfinite(a.options.moment.timeSeconds))
        return parser.wrongUsage(QStringLiteral("--time takes seconds"));
    if (parser.isSet(edge)) {
        a.options.edgeLength = parser.value(edge).toDouble(&isEdge);
        if (!isEdge || !std::isfinite(a.options.edgeLength) || a.options.edgeLength <= 0)
            return parser.wrongUsage(QStringLiteral("--edge takes a length above 0"));
    }
    TerminalJob job(a.quiet);
    try {
        return run(a, job);
    } catch (const std::bad_alloc &) {
        return failed(job, {ErrorCode::TooLarge, "Exporting the painting",
                            "the memory does not suffice for it", "Give a longer --edge", a.input.string()});
    }
}

} // namespace ductus
