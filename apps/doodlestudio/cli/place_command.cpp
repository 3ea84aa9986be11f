#include "doodlestudio/cli/place_command.h"

#include "base/error_place.h"
#include "cli/batch_command.h"
#include "cli/project_output.h"
#include "doodlestudio/cli/whole_shot.h"
#include "doodlestudio/document/placing.h"
#include "doodling/canvas/edit_scene.h"
#include "doodling/prop/prop_link.h"
#include "project/project_reader.h"

#include <cmath>
#include <cstdio>

namespace ductus {

namespace {

constexpr char placing[] = "Placing the painting";

struct PlaceArguments
{
    std::filesystem::path project, painting, output;
    QString look, name;
    std::vector<double> box; // frame, x, y, width, height; pixels of the clip
    std::optional<double> distance, turnDegrees;
    bool follows = false;
};

std::vector<double> numbersOf(const QString &text)
{
    std::vector<double> numbers;
    for (const QString &part : text.split(QLatin1Char(','))) {
        bool isNumber = false;
        const double number = part.trimmed().toDouble(&isNumber);
        if (!isNumber || !std::isfinite(number))
            return {};
        numbers.push_back(number);
    }
    return numbers;
}

Result<Prop> propOf(const PlaceArguments &a, const OpenedDoodle &doodle)
{
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    const std::filesystem::path file = a.painting.empty() ? a.project : a.painting;
    const Result<Project> project = openProject(file, options);
    if (!project)
        return placedIn(project.error(), file);
    const std::filesystem::path target = a.output.empty() ? a.project : a.output;
    const std::string name =
        a.painting.empty() ? "" : linkedFileName(file, std::filesystem::absolute(target).parent_path());
    Result<Prop> prop = propFromProject(*project, name);
    if (!prop)
        return placedIn(prop.error(), file);
    const Painting &painting = prop->painting->painting();
    prop->look = a.look.toStdString();
    if (!a.look.isEmpty() && !lookNamed(painting, prop->look)) {
        std::string looks;
        for (const Look &look : painting.looks)
            looks += (looks.empty() ? "\"" : ", \"") + look.name + "\"";
        return Error{ErrorCode::InvalidArgument, placing, "it has no look \"" + prop->look + "\"",
                     looks.empty() ? "Leave out --look" : "Its looks: " + looks, file.string()};
    }
    if (hasMotion(painting))
        prop->framesPerSecond = doodle.content->clip().framesPerSecond;
    return prop;
}

ExitCode run(const PlaceArguments &a, TerminalJob &job)
{
    const Result<OpenedDoodle> doodle = openDoodle(a.project);
    if (!doodle)
        return failed(job, doodle.error());
    const DoodleContent &content = *doodle->content;
    const int frame = int(a.box[0]);
    if (frame < 0 || frame >= content.clip().frameCount)
        return failed(job, {ErrorCode::InvalidArgument, placing,
                            "the clip has the frames 0 to " + std::to_string(content.clip().frameCount - 1),
                            "Choose one of them", a.project.string()});
    Result<Prop> prop = propOf(a, *doodle);
    if (!prop)
        return failed(job, prop.error());
    const std::shared_ptr<const Shot> shot = availableShot(*doodle, job.control());
    const Vec2 corner(a.box[1], a.box[2]);
    Canvas canvas =
        propInBox(*shot, frame, shot->scale() * corner, shot->scale() * (corner + Vec2(a.box[3], a.box[4])),
                  std::move(*prop), a.distance);
    if (!a.name.isEmpty())
        canvas.name = a.name.toStdString();
    if (a.follows)
        canvas.motion = CanvasMotion::Dynamic;
    if (a.turnDegrees) {
        // About what is up on the sheet, seen from above counter-clockwise.
        const Eigen::Quaterniond facing(shot->cameras[std::size_t(frame)].worldFromCamera.linear());
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(-*a.turnDegrees * M_PI / 180.0, Vec3::UnitY()));
        canvas.keyframes.turns = {{frame, (facing * turn).normalized(), false}};
    }
    Result<DoodleScene> scene = withCanvas(*content.scene(), std::move(canvas));
    if (!scene)
        return failed(job, scene.error());
    Project changed = doodle->project;
    for (ProjectDocument &document : changed.documents)
        if (document.content == doodle->content)
            document.content = std::make_shared<const DoodleContent>(
                content.clip(), content.shot(), content.unknown(),
                std::make_shared<const DoodleScene>(std::move(*scene)), content.packsAnalysis());
    if (Result<void> saved = saveProjectFile(changed, a.output.empty() ? a.project : a.output, placing);
        !saved)
        return failed(job, saved.error());
    job.finishLine();
    return ExitCode::Done;
}

} // namespace

ExitCode runPlaceCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("place"),
        QStringLiteral("Stands a painting of LayerPainter in the scene of P.ductus: drawn by the shot's "
                       "camera, hidden by what is filmed before it. Without PAINTING.ductus the painting of "
                       "P.ductus itself."));
    const QCommandLineOption box(
        QStringLiteral("box"),
        QStringLiteral("Where it is seen in a frame, pixels of the clip: it stands on "
                       "the lower edge and fills the box."),
        QStringLiteral("FRAME,X,Y,WIDTH,HEIGHT"));
    const QCommandLineOption look(QStringLiteral("look"), QStringLiteral("The look it is shown in."),
                                  QStringLiteral("NAME"));
    const QCommandLineOption distance(
        QStringLiteral("distance"),
        QStringLiteral("How far away it stands, scene units. Default: as far as what is seen at its foot."),
        QStringLiteral("D"));
    const QCommandLineOption turn(QStringLiteral("turn"),
                                  QStringLiteral("Turned about, degrees. Default: 0, it faces the camera."),
                                  QStringLiteral("DEGREES"));
    const QCommandLineOption follow(QStringLiteral("follow"),
                                    QStringLiteral("It follows what is under it instead of standing still."));
    const QCommandLineOption name(QStringLiteral("name"), QStringLiteral("The name of its canvas."),
                                  QStringLiteral("NAME"));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The project to write; without it P.ductus itself."),
                                    QStringLiteral("OUT.ductus"));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project with the filmed scene."));
    parser.addPositional(QStringLiteral("PAINTING.ductus"), QStringLiteral("The project with the painting."),
                         QStringLiteral("[PAINTING.ductus]"));
    for (const QCommandLineOption &option : {box, look, distance, turn, follow, name, output})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 2))
        return *end;
    PlaceArguments a{parser.positionalPath(0),
                     {},
                     parser.path(output),
                     parser.value(look),
                     parser.value(name),
                     numbersOf(parser.value(box)),
                     {},
                     {},
                     parser.isSet(follow)};
    if (parser.positional().size() > 1)
        a.painting = parser.positionalPath(1);
    if (a.box.size() != 5 || a.box[3] <= 0 || a.box[4] <= 0)
        return parser.wrongUsage(QStringLiteral("--box FRAME,X,Y,WIDTH,HEIGHT is missing"));
    for (const auto &[option, value] :
         {std::pair(&distance, &a.distance), std::pair(&turn, &a.turnDegrees)}) {
        if (!parser.isSet(*option))
            continue;
        const std::vector<double> number = numbersOf(parser.value(*option));
        if (number.size() != 1)
            return parser.wrongUsage(QStringLiteral("--%1 takes a number").arg(option->names().first()));
        *value = number[0];
    }
    if (a.distance && *a.distance <= 0)
        return parser.wrongUsage(QStringLiteral("--distance takes a number above 0"));
    if (!a.output.empty() && !hasExtension(a.output, ".ductus"))
        return parser.wrongUsage(QStringLiteral("the project must end in .ductus"));
    TerminalJob job(parser.isQuiet());
    return run(a, job);
}

} // namespace ductus
