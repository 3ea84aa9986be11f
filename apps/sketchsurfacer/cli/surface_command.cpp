#include "sketchsurfacer/cli/surface_command.h"

#include "cli/output_files.h"
#include "cli/terminal_job.h"
#include "formats/mesh_file.h"
#include "formats/png_file.h"
#include "geometry/remesh.h"
#include "sketchsurfacer/cli/ambiguity_output.h"
#include "sketchsurfacer/cli/print_report.h"
#include "sketchsurfacer/cli/project_output.h"
#include "sketchsurfacer/cli/result_picture.h"
#include "sketchsurfacer/cli/scribble_file.h"
#include "sketchsurfacer/cli/sketch_input.h"
#include "sketchsurfacer/cli/surface_arguments.h"
#include "sketchsurfacer/cli/surface_report.h"
#include "surfacing/parts/cable_proposal.h"

#include <cstdio>
#include <new>
#include <span>
#include <utility>

namespace ductus {

namespace {

// Median distance of strokes to the surface, share of the diagonal, above which the result is surely not what
// was meant: ten times what sketches of people have.
constexpr double notFollowed = 0.03;

constexpr char writingMesh[] = "Writing the mesh";
constexpr char writingProject[] = "Writing the project";
constexpr char writingReport[] = "Writing the report";
constexpr char writingPicture[] = "Writing the picture";
constexpr char writingAmbiguity[] = "Writing what the sketch leaves open";

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

// Who has a project or a proxy has decided already.
Result<void> findCables(const SurfaceArguments &a, SketchInput &sketch, const JobControl &control)
{
    if (!a.findCables || sketch.options || sketch.givenProxy || !a.proxy.empty())
        return {};
    const Result<std::vector<int>> cables = markCables(sketch.strokes, {}, control);
    if (!cables)
        return cables.error();
    for (int id : *cables)
        std::fprintf(
            stderr,
            "sketchsurfacer: Stroke %d is taken for a cable; with --parts off it is one of the surface\n",
            id);
    return {};
}

// What can be known to fail after the work is better told before it.
Result<void> checkOutputs(const SurfaceArguments &a)
{
    const std::pair<const std::filesystem::path *, const char *> outputs[] = {
        {&a.output, writingMesh},
        {&a.report, writingReport},
        {&a.picture, writingPicture},
        {&a.ambiguity, writingAmbiguity}};
    for (const auto &[path, attempted] : outputs) {
        if (path->empty())
            continue;
        if (Result<void> writable = checkWritable(*path, attempted); !writable)
            return writable;
        std::vector<std::filesystem::path> inputs = a.inputs;
        inputs.insert(inputs.end(), {a.proxy, a.scribbles});
        for (const std::filesystem::path &input : inputs)
            if (!input.empty() && isSameFile(*path, input))
                return Error{ErrorCode::InvalidArgument, attempted,
                             "this file is also read; it would be overwritten", "Choose another name",
                             path->string()};
    }
    return {};
}

// "front.curves + back.curves"
std::string nameOf(const SurfaceArguments &a)
{
    std::string name;
    for (const std::filesystem::path &input : a.inputs)
        name += (name.empty() ? "" : " + ") + input.filename().string();
    return name;
}

// However many strokes there are: without width there is no side for a surface to be on.
Result<void> checkHasWidth(const StrokeSet &strokes, const std::string &place)
{
    std::vector<Vec3> points;
    for (const Stroke &stroke : strokes.strokes)
        if (stroke.role == StrokeRole::Surface || stroke.role == StrokeRole::Boundary)
            points.insert(points.end(), stroke.points.begin(), stroke.points.end());
    const Box3 box = boundingBox(points);
    if (points.empty() || !(box.diagonal() > 0.0))
        return {}; // too little of anything; the engine says so
    Vec3 farthest = points.front();
    for (const Vec3 &p : points)
        if ((p - points.front()).norm() > (farthest - points.front()).norm())
            farthest = p;
    const Vec3 along = (farthest - points.front()).normalized();
    for (const Vec3 &p : points)
        if ((p - points.front()).cross(along).norm() > 1e-6 * box.diagonal())
            return {};
    return Error{ErrorCode::TooLittleData, "Surfacing the sketch", "all strokes lie on one straight line",
                 "Draw strokes that go around the shape", place};
}

// Repaired here and not only in the engine, so that an error names the file it is about.
Result<TriangleMesh> readProxy(const std::filesystem::path &path, const JobControl &control)
{
    const Result<TriangleMesh> mesh = readMesh(path, control);
    if (!mesh)
        return mesh;
    RepairReport report;
    Result<TriangleMesh> sound = repaired(*mesh, &report);
    if (!sound) {
        Error error = sound.error();
        error.place = path.string();
        return error;
    }
    const auto warn = [&](const char *text) {
        std::fprintf(stderr, "sketchsurfacer: %s: %s\n", path.string().c_str(), text);
    };
    if (report.splitVertices > 0)
        warn("the proxy is not a manifold; it was cut where sheets touch or branch");
    if (report.selfIntersecting)
        warn("the proxy cuts through itself; the surface may do so too");
    return sound;
}

// All files asked for, or none of them.
Result<void> writeOutputs(const SurfaceArguments &a, const SurfacingState &state,
                          const std::optional<TriangleMesh> &proxy, const std::vector<Scribble> &scribbles,
                          const JobControl &control)
{
    const StrokeSet &strokes = state.sketch->input;
    const SurfaceResult &result = *state.surface;
    OutputFiles files;
    if (!a.report.empty()) {
        const Result<PrintCheck> check = checkForPrint(result.mesh, control.part(0.0, 0.2));
        if (!check)
            return check.error();
        nlohmann::ordered_json report =
            surfaceReport(nameOf(a), int(scribbles.size()), strokes, state.options, result);
        report["print"] = printReport(*check, strokes.metresPerUnit);
        const std::string text = report.dump(2) + "\n";
        if (Result<void> added = files.add(a.report, std::as_bytes(std::span(text)), writingReport); !added)
            return added;
    }
    if (!a.picture.empty()) {
        const Result<std::vector<std::byte>> png = encodePng(resultPicture(strokes, result));
        if (!png)
            return png.error();
        if (Result<void> added = files.add(a.picture, *png, writingPicture); !added)
            return added;
    }
    if (!a.ambiguity.empty()) {
        control.progress(0.2, "Trying what else the strokes could mean");
        const Result<std::vector<std::byte>> bytes =
            ambiguityBytes(state, a.ambiguity, control.part(0.2, 0.9));
        if (!bytes)
            return bytes.error();
        if (Result<void> added = files.add(a.ambiguity, *bytes, writingAmbiguity); !added)
            return added;
    }
    if (isProjectExtension(a.output)) {
        const Result<Bytes> project = projectBytes(state, proxy, scribbles, a.inputs.front().stem().string());
        if (!project)
            return project.error();
        if (Result<void> added = files.add(a.output, *project, writingProject); !added)
            return added;
    } else {
        MeshFileContent content;
        content.mesh = result.mesh;
        content.triangleRegions = result.triangleRegions;
        content.featureLines = result.featureLines;
        content.comment = "SketchSurfacer surface of " + nameOf(a);
        const Result<std::string> mesh = meshBytes(content, a.output.extension().string(), control);
        if (!mesh)
            return mesh.error();
        if (Result<void> added = files.add(a.output, std::as_bytes(std::span(*mesh)), writingMesh); !added)
            return added;
    }
    if (control.isCancelled())
        return cancelledError(writingMesh);
    return files.commit();
}

std::string summary(const SurfaceResult &result)
{
    char text[256];
    std::snprintf(
        text, sizeof text,
        "%d vertices, %zu regions, %zu creases; strokes lie within %.2f %% of the diagonal (median), %.2f %% "
        "(95th percentile); %.1f s",
        result.mesh.vertexCount(), result.regions.size(), result.featureLines.size(),
        100 * result.deviation.median, 100 * result.deviation.p95, result.timings.total);
    return text;
}

Result<SurfacingState> surfaced(const StrokeSet &strokes, const std::optional<TriangleMesh> &proxy,
                                const std::vector<Scribble> &scribbles, const SurfaceOptions &options,
                                const JobControl &control)
{
    const Result<SurfacingState> prepared = prepareSurfacing(strokes, proxy, options, control.part(0.0, 0.5));
    if (!prepared)
        return prepared;
    const Result<SurfacingState> labelled =
        solveLabels(*prepared, scribbles, options, control.part(0.5, 0.8));
    return labelled ? extractSurface(*labelled, options, control.part(0.8, 1.0)) : labelled;
}

ExitCode run(SurfaceArguments &a, TerminalJob &job)
{
    const JobControl control = job.control();
    if (Result<void> writable = checkOutputs(a); !writable)
        return fail(job, writable.error());

    control.progress(0.0, "Reading the sketch");
    Result<SketchInput> sketch = readSketches(a.inputs, control);
    if (!sketch)
        return fail(job, sketch.error());
    for (const std::string &warning : sketch->warnings)
        std::fprintf(stderr, "sketchsurfacer: %s\n", warning.c_str());
    for (Result<void> chosen :
         {setRoles(sketch->strokes, a.boundaryStrokes, StrokeRole::Boundary, "--boundary"),
          setRoles(sketch->strokes, a.ignoredStrokes, StrokeRole::Ignored, "--ignore"),
          setRoles(sketch->strokes, a.skeletalStrokes, StrokeRole::Skeletal, "--skeletal")})
        if (!chosen)
            return fail(job, chosen.error());
    if (Result<void> found = findCables(a, *sketch, control); !found)
        return fail(job, found.error());
    const std::string place = a.inputs.size() == 1 ? a.inputs.front().string() : nameOf(a);
    if (Result<void> hasWidth = checkHasWidth(sketch->strokes, place); !hasWidth)
        return fail(job, hasWidth.error());
    SurfaceOptions options = sketch->options.value_or(a.options);
    a.given.applyTo(options);
    std::vector<Scribble> scribbles = sketch->scribbles;
    if (!a.scribbles.empty()) {
        Result<std::vector<Scribble>> read = readScribbles(a.scribbles);
        if (!read)
            return fail(job, read.error());
        scribbles.insert(scribbles.end(), read->begin(), read->end());
    }
    std::optional<TriangleMesh> proxy = sketch->givenProxy;
    if (!a.proxy.empty()) {
        Result<TriangleMesh> mesh = readProxy(a.proxy, control);
        if (!mesh)
            return fail(job, mesh.error());
        proxy = std::move(*mesh);
    }

    const double solved = a.ambiguity.empty() ? 0.97 : 0.5;
    const Result<SurfacingState> state =
        surfaced(sketch->strokes, proxy, scribbles, options, control.part(0.02, solved));
    if (!state) {
        Error error = state.error();
        if (error.place.empty())
            error.place = nameOf(a);
        else if (!a.scribbles.empty())
            error.place = a.scribbles.string() + ": " + error.place;
        return fail(job, error);
    }
    const SurfaceResult *result = state->surface.get();

    control.progress(solved, "Writing the result");
    if (Result<void> written = writeOutputs(a, *state, proxy, scribbles, control.part(solved, 1.0)); !written)
        return fail(job, written.error());

    control.progress(1.0, "Done");
    job.finishLine();
    for (const std::string &warning : result->warnings)
        std::fprintf(stderr, "sketchsurfacer: %s\n", warning.c_str());
    if (result->deviation.median > notFollowed)
        std::fprintf(stderr,
                     "sketchsurfacer: The surface does not follow the strokes: half of them lie farther than "
                     "%.1f %% of "
                     "the diagonal from it. %s\n",
                     100 * result->deviation.median,
                     a.proxy.empty() ? "A proxy mesh of your own (--proxy) may help."
                                     : "The proxy may have another shape, place or scale than the sketch.");
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
    try {
        return run(*parsed.arguments, job);
    } catch (const std::bad_alloc &) {
        return fail(job, {ErrorCode::TooLarge, "Surfacing the sketch", "the memory does not suffice for it",
                          "Thin the sketch out, or lower --proxy-vertices", nameOf(*parsed.arguments)});
    }
}

} // namespace ductus
