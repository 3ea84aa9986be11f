#include "layerpainter/cli/render_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "formats/film/film_writer.h"
#include "formats/png_file.h"
#include "layerpainter/cli/look_argument.h"
#include "layerpainter/cli/open_painting.h"
#include "layerpainter/film/painting_film.h"

#include <cmath>
#include <cstdio>

namespace ductus {

namespace {

constexpr char writing[] = "Writing the picture";

struct RenderArguments
{
    std::filesystem::path input;
    std::filesystem::path output;
    QString look; // name; empty: as the layers are
    bool everyLook = false;
    std::vector<double> camera; // eye, target, view angle; empty: the painting's own
    PaintingFilm film;
    double seconds = 0; // 0: as long as it moves
    bool isStill = false;
    bool quiet = false;
};

// A painting nobody gave a motion turns around once in this time.
constexpr double turntableSeconds = 8;

void completePlan(RenderArguments &a, const Painting &painting)
{
    FilmPlan &plan = a.film.plan;
    if (!a.camera.empty()) {
        const FrameCamera camera = FrameCamera::lookingAt({a.camera[0], a.camera[1], a.camera[2]},
                                                          {a.camera[3], a.camera[4], a.camera[5]}, 40, 1);
        plan.from = CameraKey{0, camera.eye, camera.rotation, a.camera.size() > 6 ? a.camera[6] : 40, {}};
    }
    if (a.isStill) {
        plan.frames = 1;
        return;
    }
    const double moves = motionSeconds(painting);
    if (moves <= 0 && !plan.from && plan.view == FilmPlan::View::Path)
        plan.view = FilmPlan::View::Turntable;
    if (plan.frames == 0)
        plan.frames = framesOf(a.seconds > 0 ? a.seconds : moves > 0 ? moves : turntableSeconds, plan.rate);
}

Result<void> writeStill(const std::shared_ptr<const Painting> &painting, const PaintingFilm &film,
                        const std::filesystem::path &path, const JobControl &control)
{
    const std::unique_ptr<FrameMaker> frames = makeFrames(painting, film.frames);
    const double aspect = double(film.frames.width) / film.frames.height;
    const Result<Image> image = frames->frame({film.plan.beginSeconds, film.look},
                                              cameraOf(*painting, film.plan, 0, aspect), control);
    if (!image)
        return image.error();
    const Result<std::vector<std::byte>> png = encodePng(*image);
    if (!png)
        return png.error();
    OutputFiles files;
    if (Result<void> added = files.add(path, *png, writing); !added)
        return added;
    if (control.isCancelled())
        return cancelledError(writing);
    return files.commit();
}

ExitCode run(RenderArguments a, TerminalJob &job)
{
    const JobControl control = job.control();
    if (a.isStill && !a.everyLook)
        if (Result<void> writable = checkWritable(a.output, writing); !writable)
            return failed(job, writable.error());
    Result<Painting> opened = openPainting(a.input, control.part(0, 0.1));
    if (!opened)
        return failed(job, opened.error());
    const auto painting = std::make_shared<const Painting>(std::move(*opened));
    completePlan(a, *painting);

    std::vector<std::pair<std::filesystem::path, std::optional<LookId>>> outputs;
    if (a.everyLook) {
        for (const Look &look : painting->looks)
            outputs.emplace_back(pathForLook(a.output, look.name, int(outputs.size()) + 1), look.id);
        if (outputs.empty())
            return failed(job, {ErrorCode::InvalidArgument, "Choosing the look", "the painting has no looks",
                                "Leave --every-look out", a.input.string()});
    } else {
        const Result<std::optional<LookId>> look = lookNamed(*painting, a.look);
        if (!look)
            return failed(job, look.error());
        outputs.emplace_back(a.output, *look);
    }
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto &[path, look] = outputs[i];
        const auto share = [&](std::size_t n) { return 0.1 + 0.9 * double(n) / double(outputs.size()); };
        const JobControl part = control.part(share(i), share(i + 1));
        a.film.look = look;
        const Result<void> written =
            a.isStill ? writeStill(painting, a.film, path, part) : writeFilm(painting, a.film, path, part);
        if (!written)
            return failed(job, written.error());
    }
    control.progress(1.0, "Done");
    job.finishLine();
    if (!a.quiet && !a.isStill)
        std::fprintf(stderr, "%s: %d frames, %dx%d, %.4g a second\n", outputs.front().first.string().c_str(),
                     a.film.plan.frames, a.film.frames.width, a.film.frames.height,
                     a.film.plan.rate.perSecond());
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

/// What is wrong with a number given on the command line; null if nothing is.
const char *readFilmNumbers(const BatchParser &parser, const QCommandLineOption &seconds,
                            const QCommandLineOption &frames, const QCommandLineOption &rate,
                            const QCommandLineOption &turntable, RenderArguments &a)
{
    FilmPlan &plan = a.film.plan;
    bool isNumber = false;
    if (parser.isSet(seconds)) {
        a.seconds = parser.value(seconds).toDouble(&isNumber);
        if (!isNumber || !(a.seconds > 0) || a.seconds > 86400)
            return "--seconds takes seconds, more than 0 and at most a day";
    }
    if (parser.isSet(frames)) {
        plan.frames = parser.value(frames).toInt(&isNumber);
        if (!isNumber || plan.frames < 1 || plan.frames > 10'000'000)
            return "--frames takes a whole number from 1";
        if (parser.isSet(seconds))
            return "--seconds and --frames say the same; leave one out";
    }
    const double perSecond = parser.value(rate).toDouble(&isNumber);
    if (!isNumber || !(perSecond >= 1) || perSecond > 240)
        return "--fps takes 1 to 240 frames a second";
    plan.rate = frameRateNear(perSecond);
    if (parser.isSet(turntable)) {
        plan.view = FilmPlan::View::Turntable;
        plan.turns = parser.value(turntable).toDouble(&isNumber);
        if (!isNumber || plan.turns == 0 || !(std::abs(plan.turns) <= 1000))
            return "--turntable takes how often the view goes around, < 0 the other way";
    }
    return nullptr;
}

} // namespace

ExitCode runRenderCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("render"),
        QStringLiteral("Draws a still or a film of a painting, without a window.\n\n"
                       "A film shows the motion and the camera path; a painting that has none turns around "
                       "once.\n\nIN: a project, or anything import reads."));
    const QCommandLineOption output(
        {QStringLiteral("o"), QStringLiteral("output")},
        QStringLiteral("A picture (.png), a film (.mp4, .webm, .gif), or a folder for a film's pictures."),
        QStringLiteral("OUT"));
    const QCommandLineOption look(QStringLiteral("look"), QStringLiteral("The look to show, by its name."),
                                  QStringLiteral("NAME"));
    const QCommandLineOption everyLook(QStringLiteral("every-look"),
                                       QStringLiteral("One output for each look, its name added to OUT's."));
    const QCommandLineOption camera(
        QStringLiteral("camera"),
        QStringLiteral("Eye, target and vertical angle in degrees, scene units. Default: "
                       "the painting's camera, or all of it."),
        QStringLiteral("x,y,z,x,y,z[,angle]"));
    const QCommandLineOption size(QStringLiteral("size"), QStringLiteral("Pixels. Default: 1280x800."),
                                  QStringLiteral("WxH"), QStringLiteral("1280x800"));
    const QCommandLineOption time(QStringLiteral("time"),
                                  QStringLiteral("Second of the motion, of films the first one. Default: 0."),
                                  QStringLiteral("S"), QStringLiteral("0"));
    const QCommandLineOption samples(
        QStringLiteral("samples"), QStringLiteral("Samples along each side of a pixel, 1 to 8. Default: 2."),
        QStringLiteral("N"), QStringLiteral("2"));
    const QCommandLineOption transparent(QStringLiteral("transparent"),
                                         QStringLiteral("Without background."));
    const QCommandLineOption seconds(
        QStringLiteral("seconds"), QStringLiteral("Length of the film. Default: as long as it moves, or 8."),
        QStringLiteral("S"));
    const QCommandLineOption frames(QStringLiteral("frames"),
                                    QStringLiteral("The same as a number of frames."), QStringLiteral("N"));
    const QCommandLineOption rate(QStringLiteral("fps"), QStringLiteral("Frames a second. Default: 25."),
                                  QStringLiteral("N"), QStringLiteral("25"));
    const QCommandLineOption turntable(QStringLiteral("turntable"),
                                       QStringLiteral("The view goes around the painting so often."),
                                       QStringLiteral("TURNS"));
    const QCommandLineOption reference(
        QStringLiteral("reference"),
        QStringLiteral("By the processor alone: slow, exact, the same bytes on every machine. Also done "
                       "where there is no OpenGL 4.3."));
    parser.addPositional(QStringLiteral("IN"), QStringLiteral("The painting."));
    for (const QCommandLineOption &option : {output, look, everyLook, camera, size, time, samples,
                                             transparent, seconds, frames, rate, turntable, reference})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    RenderArguments a;
    a.input = parser.positionalPath(0);
    a.output = parser.path(output);
    a.look = parser.value(look);
    a.everyLook = parser.isSet(everyLook);
    a.quiet = parser.isQuiet();
    a.film.frames.transparentBackground = parser.isSet(transparent);
    a.film.frames.exact = parser.isSet(reference);
    a.isStill = hasExtension(a.output, ".png");
    if (a.output.empty() || (!a.isStill && !filmKindOf(a.output)))
        return parser.wrongUsage(QStringLiteral("-o OUT is missing: a .png, .mp4, .webm, .gif or a folder"));
    if (a.everyLook && !a.look.isEmpty())
        return parser.wrongUsage(QStringLiteral("--look and --every-look exclude each other"));
    const QStringList sides = parser.value(size).split(QLatin1Char('x'));
    bool isWidth = false, isHeight = false, isTime = false, isCount = false;
    FrameOptions &pixels = a.film.frames;
    pixels.width = sides.value(0).toInt(&isWidth);
    pixels.height = sides.value(1).toInt(&isHeight);
    const auto isSide = [](int side) { return side >= 1 && side <= 16384; };
    if (sides.size() != 2 || !isWidth || !isHeight || !isSide(pixels.width) || !isSide(pixels.height))
        return parser.wrongUsage(QStringLiteral("--size takes pixels such as 1280x800, each 1 to 16384"));
    a.film.plan.beginSeconds = parser.value(time).toDouble(&isTime);
    pixels.samplesPerAxis = parser.value(samples).toInt(&isCount);
    if (!isTime || !std::isfinite(a.film.plan.beginSeconds))
        return parser.wrongUsage(QStringLiteral("--time takes seconds"));
    if (!isCount || pixels.samplesPerAxis < 1 || pixels.samplesPerAxis > 8)
        return parser.wrongUsage(QStringLiteral("--samples takes a whole number from 1 to 8"));
    if (const char *problem = readFilmNumbers(parser, seconds, frames, rate, turntable, a))
        return parser.wrongUsage(QLatin1String(problem));
    if (parser.isSet(camera)) {
        a.camera = numbers(parser.value(camera));
        const bool isAngle = a.camera.size() < 7 || (a.camera[6] >= 1 && a.camera[6] <= 170);
        if ((a.camera.size() != 6 && a.camera.size() != 7) || !isAngle)
            return parser.wrongUsage(
                QStringLiteral("--camera takes six numbers, or seven with an angle of 1 to 170"));
    }
    TerminalJob job(a.quiet);
    return run(std::move(a), job);
}

} // namespace ductus
