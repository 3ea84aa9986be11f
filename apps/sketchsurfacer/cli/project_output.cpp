#include "sketchsurfacer/cli/project_output.h"

#include "base/random.h"
#include "base/sha256.h"
#include "project/project_writer.h"
#include "sketchsurfacer/document/project_conversion.h"

#include <span>

namespace ductus {

namespace {

// Names drawn from the content instead of from chance, so that the same command gives the same bytes.
Random randomFrom(const SurfacingState &state, const std::string &name)
{
    Sha256 hash;
    hash.add(std::as_bytes(std::span(name)));
    for (const Stroke &stroke : state.sketch->input.strokes)
        hash.add(std::as_bytes(std::span(stroke.points)));
    hash.add(std::as_bytes(std::span(state.surface->mesh.vertices)));
    return Random(std::stoull(hash.hexDigest().substr(0, 16), nullptr, 16));
}

} // namespace

Result<Bytes> projectBytes(const SurfacingState &state, const std::optional<TriangleMesh> &givenProxy,
                           const std::vector<Scribble> &scribbles, const std::string &name)
{
    SketchContent content;
    content.strokes = std::make_shared<const StrokeSet>(state.sketch->input);
    content.options = state.options;
    content.scribbles = scribbles;
    if (givenProxy)
        content.givenProxy = std::make_shared<const TriangleMesh>(*givenProxy);
    Random random = randomFrom(state, name);
    Project project;
    project.generator = "SketchSurfacer";
    project.id = Uuid::from(random);
    putSketch(content, &state, Uuid::from(random), name, project);
    Result<SerializedProject> written = serializedProject(project);
    if (!written)
        return written.error();
    return std::move(written->bytes);
}

} // namespace ductus
