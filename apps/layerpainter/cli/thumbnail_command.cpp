#include "layerpainter/cli/thumbnail_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "formats/png_file.h"
#include "layerpainter/cli/look_argument.h"
#include "layerpainter/cli/open_painting.h"
#include "layerpainter/film/film_plan.h"
#include "layerpainter/film/frame_maker.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr char writing[] = "Writing the thumbnail";
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
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The picture."), QStringLiteral("OUT.png"));
    const QCommandLineOption size(QStringLiteral("size"), QStringLiteral("The longer side. Default: 256."),
                                  QStringLiteral("N"), QStringLiteral("256"));
    const QCommandLineOption look(QStringLiteral("look"), QStringLiteral("The look to show, by its name."),
                                  QStringLiteral("NAME"));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    for (const QCommandLineOption &option : {output, size, look})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::filesystem::path target = parser.path(output);
    if (target.empty() || !hasExtension(target, ".png"))
        return parser.wrongUsage(QStringLiteral("-o OUT.png is missing"));
    bool isSize = false;
    const int pixels = parser.value(size).toInt(&isSize);
    if (!isSize || pixels < 16 || pixels > 16384)
        return parser.wrongUsage(QStringLiteral("--size takes a whole number from 16 to 16384"));
    TerminalJob job(parser.isQuiet());
    if (Result<void> writable = checkWritable(target, writing); !writable)
        return failed(job, writable.error());
    Result<Painting> painting = openPainting(parser.positionalPath(0), job.control().part(0, 0.4));
    if (!painting)
        return failed(job, painting.error());
    const Result<Image> image =
        picture(std::move(*painting), parser.value(look), pixels, job.control().part(0.4, 1));
    if (!image)
        return failed(job, image.error());
    if (Result<void> written = writePng(*image, target); !written)
        return failed(job, written.error());
    job.finishLine();
    return ExitCode::Done;
}

} // namespace ductus
