#include "doodlestudio/cli/thumbnail_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "doodlestudio/cli/whole_shot.h"
#include "doodling/compositing/doodle_painter.h"
#include "doodling/export/export_film.h"
#include "formats/png_file.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr char writing[] = "Writing the thumbnail";

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
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The picture."), QStringLiteral("OUT.png"));
    const QCommandLineOption size(QStringLiteral("size"),
                                  QStringLiteral("The longer side at most. Default: 256."),
                                  QStringLiteral("N"), QStringLiteral("256"));
    const QCommandLineOption frame(QStringLiteral("frame"), QStringLiteral("Default: the one halfway."),
                                   QStringLiteral("N"));
    const QCommandLineOption clip(QStringLiteral("clip"),
                                  QStringLiteral("Where the clip is now, if it was moved."),
                                  QStringLiteral("CLIP"));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    for (const QCommandLineOption &option : {output, size, frame, clip})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::filesystem::path target = parser.path(output);
    if (target.empty() || !hasExtension(target, ".png"))
        return parser.wrongUsage(QStringLiteral("-o OUT.png is missing"));
    bool isSize = false, isFrame = true;
    const int pixels = parser.value(size).toInt(&isSize);
    const int wanted = parser.isSet(frame) ? parser.value(frame).toInt(&isFrame) : -1;
    if (!isSize || pixels < 16 || pixels > 16384)
        return parser.wrongUsage(QStringLiteral("--size takes a whole number from 16 to 16384"));
    if (!isFrame || (parser.isSet(frame) && wanted < 0))
        return parser.wrongUsage(QStringLiteral("--frame takes a whole number from 0"));
    TerminalJob job(parser.isQuiet());
    if (Result<void> writable = checkWritable(target, writing); !writable)
        return failed(job, writable.error());
    const Result<OpenedDoodle> doodle = openDoodle(parser.positionalPath(0));
    if (!doodle)
        return failed(job, doodle.error());
    const Result<Image> image = picture(*doodle, parser.path(clip), pixels, wanted, job.control());
    if (!image)
        return failed(job, image.error());
    if (Result<void> written = writePng(*image, target); !written)
        return failed(job, written.error());
    job.finishLine();
    return ExitCode::Done;
}

} // namespace ductus
