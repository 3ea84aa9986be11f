#include "layerpainter/cli/render_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "formats/png_file.h"
#include "layerpainter/cli/look_argument.h"
#include "layerpainter/cli/open_painting.h"
#include "layerpainter/document/default_view.h"
#include "painting/reference/reference_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ductus {

namespace {

constexpr char writing[] = "Writing the picture";

struct RenderArguments
{
    std::filesystem::path input;
    std::filesystem::path output;
    QString look;               // name; empty: as the layers are
    std::vector<double> camera; // eye, target, view angle; empty: the painting's own
    ReferenceOptions options;
};

FrameCamera cameraOf(const RenderArguments &a, const Painting &painting)
{
    const double aspect = double(a.options.width) / double(a.options.height);
    if (a.camera.empty())
        return FrameCamera::of(defaultView(painting, a.options.moment.timeSeconds, aspect), aspect);
    return FrameCamera::lookingAt({a.camera[0], a.camera[1], a.camera[2]},
                                  {a.camera[3], a.camera[4], a.camera[5]},
                                  a.camera.size() > 6 ? a.camera[6] : 40, aspect);
}

ExitCode run(RenderArguments a, TerminalJob &job)
{
    const JobControl control = job.control();
    if (Result<void> writable = checkWritable(a.output, writing); !writable)
        return failed(job, writable.error());
    const Result<Painting> painting = openPainting(a.input, control.part(0, 0.1));
    if (!painting)
        return failed(job, painting.error());
    const Result<std::optional<LookId>> look = lookNamed(*painting, a.look);
    if (!look)
        return failed(job, look.error());
    a.options.moment.look = *look;
    const Result<ReferenceFrame> frame =
        referenceFrame(*painting, cameraOf(a, *painting), a.options, control.part(0.1, 0.95));
    if (!frame)
        return failed(job, frame.error());
    const Result<std::vector<std::byte>> png = encodePng(frame->colour);
    if (!png)
        return failed(job, png.error());
    OutputFiles files;
    Result<void> written = files.add(a.output, *png, writing);
    if (written && control.isCancelled())
        written = cancelledError(writing);
    if (written)
        written = files.commit();
    if (!written)
        return failed(job, written.error());
    control.progress(1.0, "Done");
    job.finishLine();
    return ExitCode::Done;
}

// "x,y,z": numbers between commas; empty if one is none.
std::vector<double> numbers(const QString &text)
{
    std::vector<double> values;
    for (const QString &part : text.split(QLatin1Char(','))) {
        bool isNumber = false;
        values.push_back(part.toDouble(&isNumber));
        if (!isNumber || !std::isfinite(values.back()))
            return {};
    }
    return values;
}

} // namespace

ExitCode runRenderCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("render"),
        QStringLiteral("Draws a still of a painting exactly, on the processor: the same bytes on every "
                       "machine.\n\nIN: a project, or anything import reads."));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The picture."), QStringLiteral("OUT.png"));
    const QCommandLineOption look(QStringLiteral("look"), QStringLiteral("The look to show, by its name."),
                                  QStringLiteral("NAME"));
    const QCommandLineOption camera(
        QStringLiteral("camera"),
        QStringLiteral("Eye, target and vertical angle in degrees, scene units. Default: "
                       "the painting's camera, or all of it."),
        QStringLiteral("x,y,z,x,y,z[,angle]"));
    const QCommandLineOption size(QStringLiteral("size"), QStringLiteral("Pixels. Default: 1280x800."),
                                  QStringLiteral("WxH"), QStringLiteral("1280x800"));
    const QCommandLineOption time(QStringLiteral("time"), QStringLiteral("Second of the motion. Default: 0."),
                                  QStringLiteral("S"), QStringLiteral("0"));
    const QCommandLineOption samples(
        QStringLiteral("samples"), QStringLiteral("Samples along each side of a pixel, 1 to 8. Default: 2."),
        QStringLiteral("N"), QStringLiteral("2"));
    const QCommandLineOption transparent(QStringLiteral("transparent"),
                                         QStringLiteral("Without background."));
    parser.addPositional(QStringLiteral("IN"), QStringLiteral("The painting."));
    for (const QCommandLineOption &option : {output, look, camera, size, time, samples, transparent})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    RenderArguments a;
    a.input = parser.positionalPath(0);
    a.output = parser.path(output);
    a.look = parser.value(look);
    a.options.transparentBackground = parser.isSet(transparent);
    if (a.output.empty() || !hasExtension(a.output, ".png"))
        return parser.wrongUsage(QStringLiteral("-o OUT.png is missing"));
    const QStringList sides = parser.value(size).split(QLatin1Char('x'));
    bool isWidth = false, isHeight = false, isTime = false, isCount = false;
    a.options.width = sides.value(0).toInt(&isWidth);
    a.options.height = sides.value(1).toInt(&isHeight);
    const auto isSide = [](int pixels) { return pixels >= 1 && pixels <= 16384; };
    if (sides.size() != 2 || !isWidth || !isHeight || !isSide(a.options.width) || !isSide(a.options.height))
        return parser.wrongUsage(QStringLiteral("--size takes pixels such as 1280x800, each 1 to 16384"));
    a.options.moment.timeSeconds = parser.value(time).toDouble(&isTime);
    a.options.samplesPerAxis = parser.value(samples).toInt(&isCount);
    if (!isTime || !std::isfinite(a.options.moment.timeSeconds))
        return parser.wrongUsage(QStringLiteral("--time takes seconds"));
    if (!isCount || a.options.samplesPerAxis < 1 || a.options.samplesPerAxis > 8)
        return parser.wrongUsage(QStringLiteral("--samples takes a whole number from 1 to 8"));
    if (parser.isSet(camera)) {
        a.camera = numbers(parser.value(camera));
        const bool isAngle = a.camera.size() < 7 || (a.camera[6] >= 1 && a.camera[6] <= 170);
        if ((a.camera.size() != 6 && a.camera.size() != 7) || !isAngle)
            return parser.wrongUsage(
                QStringLiteral("--camera takes six numbers, or seven with an angle of 1 to 170"));
    }
    TerminalJob job(parser.isQuiet());
    return run(std::move(a), job);
}

} // namespace ductus
