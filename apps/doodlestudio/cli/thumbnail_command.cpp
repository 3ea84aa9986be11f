#include "doodlestudio/cli/thumbnail_command.h"

#include "cli/thumbnail_output.h"
#include "doodlestudio/cli/whole_shot.h"
#include "doodling/compositing/doodle_painter.h"
#include "doodling/export/export_film.h"

#include <algorithm>

namespace ductus {

namespace {

// Halfway, or the frame that was asked for.
Result<Image> picture(const OpenedDoodle &doodle, const std::filesystem::path &clipPath, int size, int frame,
                      const JobControl &control)
{
    Result<std::unique_ptr<Clip>> clip = openItsClip(doodle, clipPath, control.part(0.0, 0.3));
    if (!clip)
        return clip.error();
    const ClipInfo &info = (*clip)->info();
    const int shown = frame >= 0 ? std::min(frame, info.frameCount - 1) : info.frameCount / 2;
    const double shrink = std::min(1.0, double(size) / std::max(info.width, info.height));
    const int lines = std::max(2, int(info.height * shrink));
    const Result<Image> decoded = (*clip)->frame(shown, lines);
    if (!decoded)
        return decoded.error();
    // A picture is wanted soon: what is not in the cache is not found again for it.
    const std::shared_ptr<const Shot> whole = availableShot(doodle, control.part(0.3, 0.4));
    const Shot &shot = *whole;
    const DoodleScene &scene = *doodle.content->scene();
    const Result<std::vector<CanvasTrack>> tracks = tracksOf(shot, scene, control.part(0.4, 0.9));
    if (!tracks)
        return tracks.error();
    return DoodlePainter().composited({shot, scene, *tracks, shown}, *decoded);
}

} // namespace

ExitCode runThumbnailCommand(const QStringList &arguments)
{
    BatchParser parser(QStringLiteral("thumbnail"),
                       QStringLiteral("Draws one frame of the clip with its doodles, small."));
    const ThumbnailOptions options(QStringLiteral("The longer side at most."));
    const QCommandLineOption frame(QStringLiteral("frame"), QStringLiteral("Default: the one halfway."),
                                   QStringLiteral("N"));
    const QCommandLineOption clip(QStringLiteral("clip"),
                                  QStringLiteral("Where the clip is now, if it was moved."),
                                  QStringLiteral("CLIP"));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    for (const QCommandLineOption &option : {options.output, options.size, frame, clip})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    bool isFrame = true;
    const int wanted = parser.isSet(frame) ? parser.value(frame).toInt(&isFrame) : -1;
    if (!isFrame || (parser.isSet(frame) && wanted < 0))
        return parser.wrongUsage(QStringLiteral("--frame takes a whole number from 0"));
    return writeThumbnail(parser, options, [&](int pixels, const JobControl &control) -> Result<Image> {
        const Result<OpenedDoodle> doodle = openDoodle(parser.positionalPath(0));
        if (!doodle)
            return doodle.error();
        return picture(*doodle, parser.path(clip), pixels, wanted, control);
    });
}

} // namespace ductus
