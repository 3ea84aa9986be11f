#include "sketchsurfacer/cli/surface_command.h"

#include "cli/terminal_job.h"
#include "formats/atomic_file.h"
#include "formats/mesh_file.h"
#include "formats/png_file.h"
#include "formats/sketch_file.h"
#include "sketchsurfacer/cli/surface_arguments.h"
#include "sketchsurfacer/cli/result_picture.h"
#include "sketchsurfacer/cli/surface_report.h"

#include <cstdio>

namespace ductus {

namespace {

ExitCode fail(TerminalJob &job, const Error &error)
{
    job.finishLine();
    std::fprintf(stderr, "sketchsurfacer: %s\n", error.message().c_str());
    return exitCodeFor(error);
}

Result<void> setRoles(StrokeSet &strokes, const std::vector<int> &ids, StrokeRole role, const char *option)
{
    for (int id : ids) {
        if (id >= int(strokes.strokes.size()))
            return Error{ErrorCode::InvalidArgument, "Choosing strokes",
                         "there is no stroke " + std::to_string(id) + "; the sketch has strokes 0 to " +
                             std::to_string(int(strokes.strokes.size()) - 1),
                         std::string("Correct ") + option, ""};
        strokes.strokes[std::size_t(id)].role = role;
    }
    return {};
}

// A place that cannot be written to is better known before the work than after.
Result<void> checkWritable(const std::filesystem::path &path)
{
    std::error_code ec;
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, ec))
        return Error{ErrorCode::WriteFailed, "Writing the result", "the folder does not exist",
                     "Create it, or choose another place", path.string()};
    if (std::filesystem::is_directory(path, ec))
        return Error{ErrorCode::NotAFile, "Writing the result", "this is a folder", "Choose a file name",
                     path.string()};
    return {};
}

std::string summary(const SurfaceResult &result)
{
    char text[256];
    std::snprintf(text, sizeof text,
                  "%d vertices, %zu regions, %zu creases; strokes lie within %.2f %% of the diagonal (median), %.2f %% "
                  "(95th percentile); %.1f s",
                  result.mesh.vertexCount(), result.regions.size(), result.featureLines.size(),
                  100 * result.deviation.median, 100 * result.deviation.p95, result.timings.total);
    return text;
}

ExitCode run(SurfaceArguments &a, TerminalJob &job)
{
    const JobControl control = job.control();
    for (const std::filesystem::path *path : {&a.output, &a.report, &a.picture})
        if (!path->empty())
            if (Result<void> writable = checkWritable(*path); !writable)
                return fail(job, writable.error());

    control.progress(0.0, "Reading the sketch");
    Result<SketchFile> sketch = readSketch(a.input, {}, control);
    if (!sketch)
        return fail(job, sketch.error());
    for (const std::string &warning : sketch->warnings)
        std::fprintf(stderr, "sketchsurfacer: %s\n", warning.c_str());
    for (Result<void> chosen : {setRoles(sketch->strokes, a.boundaryStrokes, StrokeRole::Boundary, "--boundary"),
                                setRoles(sketch->strokes, a.ignoredStrokes, StrokeRole::Ignored, "--ignore")})
        if (!chosen)
            return fail(job, chosen.error());
    std::optional<TriangleMesh> proxy;
    if (!a.proxy.empty()) {
        Result<TriangleMesh> mesh = readMesh(a.proxy, control);
        if (!mesh)
            return fail(job, mesh.error());
        proxy = std::move(*mesh);
    }

    const Result<SurfaceResult> result = surfaceSketch(sketch->strokes, proxy, a.options, control.part(0.02, 0.97));
    if (!result) {
        Error error = result.error();
        if (error.place.empty())
            error.place = a.input.filename().string();
        return fail(job, error);
    }

    control.progress(0.97, "Writing the result");
    MeshFileContent content;
    content.mesh = result->mesh;
    content.triangleRegions = result->triangleRegions;
    content.featureLines = result->featureLines;
    content.comment = "SketchSurfacer surface of " + a.input.filename().string();
    // The mesh comes last: where it exists, all that was asked for beside it exists too.
    if (!a.report.empty()) {
        const std::string text = surfaceReport(a.input, sketch->strokes, a.options, *result).dump(2) + "\n";
        if (Result<void> written = writeFileAtomically(a.report, std::as_bytes(std::span(text)), "Writing the report");
            !written)
            return fail(job, written.error());
    }
    if (!a.picture.empty())
        if (Result<void> written = writePng(resultPicture(sketch->strokes, *result), a.picture); !written)
            return fail(job, written.error());
    if (Result<void> written = writeMesh(content, a.output, control.part(0.99, 1.0)); !written)
        return fail(job, written.error());

    control.progress(1.0, "Done");
    job.finishLine();
    for (const std::string &warning : result->warnings)
        std::fprintf(stderr, "sketchsurfacer: %s\n", warning.c_str());
    if (!a.quiet)
        std::fprintf(stderr, "%s: %s\n", a.output.string().c_str(), summary(*result).c_str());
    return ExitCode::Done;
}

} // namespace

ExitCode runSurfaceCommand(const QStringList &arguments)
{
    ParsedSurfaceArguments parsed = parseSurfaceArguments(arguments);
    if (!parsed.arguments) {
        std::fputs(qPrintable(parsed.message), parsed.isHelp ? stdout : stderr);
        return parsed.isHelp ? ExitCode::Done : ExitCode::WrongUsage;
    }
    TerminalJob job(parsed.arguments->quiet);
    return run(*parsed.arguments, job);
}

} // namespace ductus
