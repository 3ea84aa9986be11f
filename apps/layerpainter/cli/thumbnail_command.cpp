#include "layerpainter/cli/thumbnail_command.h"

#include "cli/thumbnail_output.h"
#include "layerpainter/cli/look_argument.h"
#include "layerpainter/cli/open_painting.h"
#include "layerpainter/film/film_plan.h"
#include "layerpainter/film/frame_maker.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double aspect = 1.6; // as of render's pictures

Result<Image> picture(Painting opened, const QString &lookName, int size, const JobControl &control)
{
    const auto painting = std::make_shared<const Painting>(std::move(opened));
    const Result<std::optional<LookId>> look = lookNamed(*painting, lookName);
    if (!look)
        return look.error();
    FrameOptions options;
    options.width = size;
    options.height = std::max(1, int(size / aspect + 0.5));
    options.samplesPerAxis = 3; // small pictures show every step of an edge
    FilmPlan plan;
    plan.frames = 1;
    const FrameCamera camera = cameraOf(*painting, plan, 0, double(options.width) / options.height);
    return makeFrames(painting, options)->frame({0, *look}, camera, control);
}

} // namespace

ExitCode runThumbnailCommand(const QStringList &arguments)
{
    BatchParser parser(QStringLiteral("thumbnail"),
                       QStringLiteral("Draws a small picture of a painting as it is first seen."));
    const ThumbnailOptions options(QStringLiteral("The longer side."));
    const QCommandLineOption look(QStringLiteral("look"), QStringLiteral("The look to show, by its name."),
                                  QStringLiteral("NAME"));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    for (const QCommandLineOption &option : {options.output, options.size, look})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    return writeThumbnail(parser, options, [&](int pixels, const JobControl &control) -> Result<Image> {
        Result<Painting> painting = openPainting(parser.positionalPath(0), control.part(0, 0.4));
        if (!painting)
            return painting.error();
        return picture(std::move(*painting), parser.value(look), pixels, control.part(0.4, 1));
    });
}

} // namespace ductus
