#include "sketchsurfacer/cli/sketch_input.h"

#include "base/error_place.h"
#include "formats/sketch_file.h"
#include "project/project_reader.h"
#include "sketchsurfacer/document/project_conversion.h"
#include "surfacing/sketch/point_cloud.h"

#include <algorithm>

namespace ductus {

namespace {

Result<SketchInput> readProject(const std::filesystem::path &path)
{
    const Result<Project> project = openProject(path);
    if (!project)
        return placedIn(project.error(), path);
    const Result<StoredSketch> stored = sketchFromProject(*project);
    if (!stored)
        return placedIn(stored.error(), path);
    SketchInput input;
    input.strokes = *stored->content.strokes;
    input.options = stored->content.options;
    if (stored->content.givenProxy)
        input.givenProxy = *stored->content.givenProxy;
    input.scribbles = stored->content.scribbles;
    input.warnings = project->warnings;
    return input;
}

Result<SketchInput> readStrokes(const std::filesystem::path &path, const JobControl &control)
{
    Result<SketchFile> sketch = readSketch(path, {}, control);
    if (!sketch)
        return sketch.error();
    if (sketch->isPointCloud)
        if (const Result<void> isSurface = checkCloudIsSurface(sketch->strokes); !isSurface)
            return placedIn(isSurface.error(), path);
    SketchInput input;
    input.strokes = std::move(sketch->strokes);
    input.warnings = std::move(sketch->warnings);
    if (sketch->isPointCloud)
        input.warnings.push_back(
            path.string() + ": these " + std::to_string(input.strokes.strokes.size()) +
            " points do not follow one another: they are taken as points of the surface, and "
            "creases are found by its shape alone");
    return input;
}

void scale(SketchInput &input, double factor)
{
    const auto scalePoints = [&](std::vector<Vec3> &points) {
        for (Vec3 &p : points)
            p *= factor;
    };
    for (Stroke &stroke : input.strokes.strokes)
        scalePoints(stroke.points);
    for (Scribble &scribble : input.scribbles)
        scalePoints(scribble.points);
    if (input.givenProxy)
        scalePoints(input.givenProxy->vertices);
}

} // namespace

bool isProjectExtension(const std::filesystem::path &path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".ductus";
}

Result<SketchInput> readSketches(const std::vector<std::filesystem::path> &paths, const JobControl &control)
{
    std::optional<SketchInput> all;
    for (const std::filesystem::path &path : paths) {
        Result<SketchInput> next = isProjectExtension(path) ? readProject(path) : readStrokes(path, control);
        if (!next)
            return next;
        if (!all) {
            all = std::move(*next);
            continue;
        }
        if (isProjectExtension(path) && next->strokes.metresPerUnit != all->strokes.metresPerUnit)
            scale(*next, next->strokes.metresPerUnit / all->strokes.metresPerUnit);
        for (Stroke &stroke : next->strokes.strokes)
            all->strokes.strokes.push_back(std::move(stroke));
        all->scribbles.insert(all->scribbles.end(), next->scribbles.begin(), next->scribbles.end());
        all->warnings.insert(all->warnings.end(), next->warnings.begin(), next->warnings.end());
        if (!all->givenProxy)
            all->givenProxy = std::move(next->givenProxy);
        all->options.reset(); // of several, none speaks for all
    }
    // Of a single project too: --boundary and --ignore count strokes and know no ids.
    for (std::size_t s = 0; s < all->strokes.strokes.size(); ++s)
        all->strokes.strokes[s].id.value = int(s);
    return std::move(*all);
}

} // namespace ductus
