#include "sketchsurfacer/document/project_conversion.h"

#include "sketchsurfacer/document/stored_decisions.h"
#include "sketchsurfacer/document/stored_reading.h"

#include <algorithm>

namespace ductus {

namespace {

// What can be shown of a surface that was solved in an earlier session.
std::shared_ptr<const SurfacingState> shownState(const StoredSurface &stored)
{
    auto surface = std::make_shared<SurfaceResult>();
    surface->mesh = stored.mesh;
    surface->triangleRegions = stored.triangleRegions;
    if (surface->triangleRegions.empty())
        surface->triangleRegions.assign(stored.mesh.triangles.size(), 0);
    surface->featureLines = stored.featureLines;
    std::size_t regions = stored.models.size();
    for (int region : surface->triangleRegions)
        regions = std::max(regions, std::size_t(region) + 1);
    surface->regions.resize(regions);
    for (std::size_t i = 0; i < stored.models.size(); ++i)
        surface->regions[i].degree = stored.models[i].degree;
    for (int t = 0; t < stored.mesh.triangleCount(); ++t)
        surface->regions[std::size_t(surface->triangleRegions[std::size_t(t)])].area +=
            0.5 * stored.mesh.areaVector(t).norm();
    auto state = std::make_shared<SurfacingState>();
    state->surface = std::move(surface);
    return state;
}

StoredSurface storedSurface(const SurfaceResult &surface)
{
    StoredSurface stored;
    stored.mesh = surface.mesh;
    stored.triangleRegions = surface.triangleRegions;
    stored.featureLines = surface.featureLines;
    for (const SurfaceRegion &region : surface.regions)
        stored.models.push_back({region.degree, {}, {}});
    return stored;
}

// Of the surface there is, as strokes may have been worked into it since the reading was chosen.
void putReading(const SketchContent &content, const SurfacingState *state,
                std::optional<StoredReading> &stored)
{
    if (!content.reading) {
        stored.reset();
        return;
    }
    if (!state || !state->hasLabels())
        state = content.reading->labelled.get();
    const UnknownMembers unknown = stored ? stored->unknown : UnknownMembers();
    stored = state ? storedReading(*state) : *content.reading->stored;
    if (state)
        stored->unknown = unknown;
}

} // namespace

Result<StoredSketch> sketchFromProject(const Project &project)
{
    for (const ProjectDocument &document : project.documents) {
        if (document.kind != sketchSurfaceKind)
            continue;
        const auto content = sketchSurfaceOf(document);
        if (!content)
            return content.error();
        const SketchSurfaceDocument &stored = **content;
        StoredSketch sketch;
        sketch.documentId = document.id;
        sketch.content.strokes = std::make_shared<const StrokeSet>(stored.strokes);
        sketch.content.options = defaultSurfaceOptions();
        if (Result<void> read = readDecisions(stored.settings, sketch.content); !read)
            return read.error();
        if (stored.reading) {
            ChosenReading reading;
            reading.strokes = sketch.content.strokes;
            reading.stored = std::make_shared<const StoredReading>(*stored.reading);
            sketch.content.reading = std::make_shared<const ChosenReading>(std::move(reading));
        }
        if (stored.proxy)
            sketch.content.givenProxy = std::make_shared<const TriangleMesh>(stored.proxy->mesh);
        if (stored.surface)
            sketch.state = shownState(*stored.surface);
        return sketch;
    }
    return Error{ErrorCode::TooLittleData, "Opening the project", "there is no sketch in it",
                 "Open it with the app it was made with", ""};
}

void putSketch(const SketchContent &content, const SurfacingState *state, const Uuid &id,
               const std::string &name, Project &project)
{
    ProjectDocument *document = project.find(id);
    SketchSurfaceDocument stored;
    if (document && document->sketchSurface)
        stored = *document->sketchSurface; // with what this version does not know
    stored.strokes = *content.strokes;
    writeDecisions(content, stored.settings);
    if (content.givenProxy) {
        if (!stored.proxy)
            stored.proxy.emplace();
        stored.proxy->mesh = *content.givenProxy;
    } else {
        stored.proxy.reset();
    }
    if (state && state->surface)
        stored.surface = storedSurface(*state->surface);
    else
        stored.surface.reset();
    putReading(content, state, stored.reading);
    std::erase_if(stored.strokeUnknown, [&](const auto &entry) {
        return std::none_of(stored.strokes.strokes.begin(), stored.strokes.strokes.end(),
                            [&](const Stroke &s) { return s.id == entry.first; });
    });
    if (document) {
        document->name = name;
        document->sketchSurface = std::make_shared<const SketchSurfaceDocument>(std::move(stored));
    } else {
        project.documents.push_back(newSketchSurface(id, name, std::move(stored)));
    }
}

} // namespace ductus
