#include "doodlestudio/cli/track_command.h"

#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "doodlestudio/cli/track_queries.h"
#include "doodlestudio/cli/whole_shot.h"
#include "formats/atomic_file.h"

#include <span>

namespace ductus {

namespace {

constexpr char writingTracks[] = "Writing the tracks";
constexpr std::size_t largestQueryFile = 256u << 20;

// Facing the camera in the first keyframe's frame, if the user turned it nowhere.
std::vector<OrientationKeyframe> orientationsOf(const TrackQuery &query, const Shot &shot)
{
    if (!query.orientations.empty())
        return query.orientations;
    const int frame = query.keyframes.front().frame;
    return {{frame, Eigen::Quaterniond(shot.cameras[std::size_t(frame)].worldFromCamera.linear())}};
}

Result<QueryAnswer> answer(const TrackQuery &query, const Shot &shot, const JobControl &control)
{
    QueryAnswer result;
    result.id = query.id;
    Result<std::vector<TrackedPoint>> points = trackPoint(shot, query.keyframes, {}, control);
    if (!points)
        return points.error();
    result.points = std::move(*points);
    std::vector<Vec3> trajectory;
    for (const TrackedPoint &point : result.points)
        trajectory.push_back(point.position);
    Result<std::vector<Eigen::Quaterniond>> turned =
        solveOrientations(trajectory, orientationsOf(query, shot), {}, control);
    if (!turned)
        return turned.error();
    result.orientations = std::move(*turned);
    return result;
}

Result<std::string> tracked(const std::filesystem::path &projectFile, const std::filesystem::path &queryFile,
                            const std::filesystem::path &clip, const JobControl &control)
{
    control.progress(0.0, "Opening the project");
    const Result<OpenedDoodle> doodle = openDoodle(projectFile);
    if (!doodle)
        return doodle.error();
    const Result<std::string> text = readWholeFile(queryFile, largestQueryFile, "Reading the queries");
    if (!text)
        return text.error();
    const Result<std::shared_ptr<const Shot>> whole = wholeShot(*doodle, clip, control.part(0.0, 0.1));
    if (!whole)
        return whole.error();
    const Shot &shot = **whole;
    const Result<std::vector<TrackQuery>> queries = parseQueries(*text, queryFile.filename().string(), shot);
    if (!queries)
        return queries.error();
    std::vector<QueryAnswer> answers;
    for (std::size_t i = 0; i < queries->size(); ++i) {
        const JobControl part = control.part(0.1 + 0.9 * double(i) / double(queries->size()),
                                             0.1 + 0.9 * double(i + 1) / double(queries->size()));
        part.progress(0.0, "Following the canvas");
        Result<QueryAnswer> one = answer((*queries)[i], shot, part);
        if (!one) {
            Error error = one.error();
            error.place = queryFile.filename().string() + ": tracks/" + std::to_string(i);
            return error.isCancelled() ? one.error() : error;
        }
        answers.push_back(std::move(*one));
        shot.forgetPages(0, shot.frameCount()); // the next point is elsewhere
    }
    return answersText(answers, shot);
}

} // namespace

ExitCode runTrackCommand(const QStringList &arguments)
{
    BatchParser parser(QStringLiteral("track"),
                       QStringLiteral("Follows points through an analysed clip from their keyframes.\n\n"
                                      "P.ductus: made by `doodlestudio analyse`."));
    const QCommandLineOption queries(QStringLiteral("queries"),
                                     QStringLiteral("The points and their keyframes."),
                                     QStringLiteral("Q.json"));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("Where they are in every frame."),
                                    QStringLiteral("T.json"));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    parser.addOption(queries);
    const QCommandLineOption clip(QStringLiteral("clip"),
                                  QStringLiteral("Where the clip is now, if it was moved. It is only read if "
                                                 "the cache was deleted."),
                                  QStringLiteral("CLIP"));
    parser.addOption(output);
    parser.addOption(clip);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::filesystem::path target = parser.path(output);
    if (!parser.isSet(queries) || target.empty())
        return parser.wrongUsage(QStringLiteral("--queries Q.json or -o T.json is missing"));
    for (const std::filesystem::path &read : {parser.positionalPath(0), parser.path(queries)})
        if (isSameFile(target, read))
            return parser.wrongUsage(QStringLiteral("-o names a file that is also read"));
    TerminalJob job(parser.isQuiet());
    if (Result<void> writable = checkWritable(target, writingTracks); !writable)
        return failed(job, writable.error());
    const Result<std::string> text =
        tracked(parser.positionalPath(0), parser.path(queries), parser.path(clip), job.control());
    if (!text)
        return failed(job, text.error());
    OutputFiles files;
    if (Result<void> added = files.add(target, std::as_bytes(std::span(*text)), writingTracks); !added)
        return failed(job, added.error());
    if (Result<void> written = files.commit(); !written)
        return failed(job, written.error());
    job.control().progress(1.0, "Done");
    job.finishLine();
    return ExitCode::Done;
}

} // namespace ductus
