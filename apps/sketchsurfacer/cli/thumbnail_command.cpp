#include "sketchsurfacer/cli/thumbnail_command.h"

#include "cli/thumbnail_output.h"
#include "document/document_files.h"
#include "imaging/surface_picture.h"
#include "project/project_reader.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr Rgba strokeColour{38, 52, 92, 255};

Image picture(const SketchSurfaceDocument &sketch, int size)
{
    PictureOptions options;
    options.width = size;
    options.height = std::max(1, size * 3 / 4);
    options.zUp = sketch.strokes.upAxis == UpAxis::Z;
    options.supersampling = 3; // small pictures show every step of an edge
    options.margin = 0.04;
    PictureScene scene;
    const double diagonal = sketch.strokes.box().diagonal();
    if (sketch.surface) {
        scene.meshes.emplace_back();
        scene.meshes.back().mesh = sketch.surface->mesh;
    }
    for (const Stroke &stroke : sketch.strokes.strokes) {
        PictureLine line;
        line.points = stroke.points;
        line.colour = strokeColour;
        line.radius = diagonal / (sketch.surface ? 400 : 250);
        line.visibleBehind = diagonal / 80;
        scene.lines.push_back(std::move(line));
    }
    return renderPicture(scene, options);
}

Result<Image> pictureOf(const std::filesystem::path &path, int size)
{
    const Result<Project> project = openProject(path, knownDocuments());
    if (!project)
        return project.error();
    for (const ProjectDocument &document : project->documents)
        if (document.sketchSurface)
            return picture(*document.sketchSurface, size);
    return Error{ErrorCode::Unsupported, "Drawing the thumbnail", "there is no sketch in the project", "",
                 path.string()};
}

} // namespace

ExitCode runThumbnailCommand(const QStringList &arguments)
{
    BatchParser parser(QStringLiteral("thumbnail"),
                       QStringLiteral("Draws a small picture of a sketch with its surface."));
    const ThumbnailOptions options(QStringLiteral("The longer side."));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    parser.addOption(options.output);
    parser.addOption(options.size);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    return writeThumbnail(parser, options, [&](int pixels, const JobControl &) {
        return pictureOf(parser.positionalPath(0), pixels);
    });
}

} // namespace ductus
