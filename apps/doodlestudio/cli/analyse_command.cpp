#include "doodlestudio/cli/analyse_command.h"

#include "base/sha256.h"
#include "cli/batch_command.h"
#include "cli/output_files.h"
#include "doodlestudio/cli/whole_shot.h"
#include "doodling/reconstruction/given/given_cameras.h"
#include "doodling/reconstruction/given/given_depth.h"
#include "doodling/reconstruction/knowledge_words.h"
#include "doodling/storage/doodle_content.h"
#include "project/project_writer.h"

#include <cstdio>

namespace ductus {

namespace {

constexpr char writingProject[] = "Writing the project";

// As seen from the project's folder: a folder with both can be moved.
std::string storedPath(const std::filesystem::path &clip, const std::filesystem::path &project)
{
    std::error_code failure;
    const std::filesystem::path absolute = std::filesystem::absolute(clip, failure).lexically_normal();
    const std::filesystem::path folder = std::filesystem::absolute(project, failure).parent_path();
    const std::filesystem::path relative = absolute.lexically_relative(folder);
    return (relative.empty() ? absolute : relative).generic_string();
}

// Ids drawn from the clip's facts: the same clip gives the same bytes.
Project projectOf(ClipReference clip, std::shared_ptr<const Shot> shot, const std::string &name,
                  bool isPacked)
{
    const std::string seed = clip.path + "/" + std::to_string(clip.frameCount) + "/" +
                             std::to_string(clip.width) + "x" + std::to_string(clip.height);
    Random random(std::stoull(sha256Hex(std::as_bytes(std::span(seed))).substr(0, 16), nullptr, 16));
    Project project;
    project.generator = "DoodleStudio";
    project.id = Uuid::from(random);
    project.documents.push_back(
        newDocument(Uuid::from(random), name,
                    std::make_shared<const DoodleContent>(std::move(clip), std::move(shot), UnknownMembers(),
                                                          nullptr, isPacked)));
    return project;
}

struct AnalyseArguments
{
    std::filesystem::path input, output, depth, cameras;
    bool packs = false;
};

Result<void> checkPackable(const AnalysedShot &analysed, const AnalyseArguments &a)
{
    const std::uint64_t bytes = packedAnalysisBytes(*analysed.shot);
    if (bytes <= mostPackedBytes || (!a.packs && analysed.shot->isCached()))
        return {};
    return Error{ErrorCode::TooLarge, "Packing the analysis",
                 "it has " + std::to_string(bytes >> 20) +
                     " megabytes, and a project is read into memory at once",
                 a.packs ? "Leave out --pack: it is kept in the cache"
                         : "Name a folder for the cache in XDG_CACHE_HOME, or cut the clip",
                 a.output.string()};
}

Result<std::vector<ShotCamera>> givenCameras(const AnalyseArguments &a, const ClipInfo &info)
{
    if (a.cameras.empty())
        return std::vector<ShotCamera>();
    Result<GivenCameras> given = readGivenCameras(a.cameras, info.frameCount, info.width, info.height);
    if (!given)
        return given.error();
    for (const std::string &warning : given->warnings)
        std::fprintf(stderr, "\ndoodlestudio: %s\n", warning.c_str());
    return std::move(given->cameras);
}

Result<Project> analysed(const AnalyseArguments &a, const JobControl &control)
{
    Result<std::unique_ptr<Clip>> clip = openClip(a.input, control.part(0.0, 0.02));
    if (!clip)
        return clip.error();
    const ClipInfo &info = (*clip)->info();
    for (const std::string &warning : info.warnings)
        std::fprintf(stderr, "\ndoodlestudio: %s\n", warning.c_str());
    // What may be wrong is found before the long work.
    Result<std::vector<ShotCamera>> cameras = givenCameras(a, info);
    if (!cameras)
        return cameras.error();
    std::vector<std::filesystem::path> maps;
    if (!a.depth.empty()) {
        Result<std::vector<std::filesystem::path>> files = depthFiles(a.depth, info.frameCount);
        if (!files)
            return files.error();
        if (Result<GivenDepth> first = readDepthFile(files->front()); !first)
            return first.error();
        maps = std::move(*files);
    }
    Result<AnalysedShot> analysed = analysedShot(**clip, a.input, userAnalysisCache(), nullptr,
                                                 control.part(0.02, 0.9), std::move(*cameras));
    if (!analysed)
        return analysed.error();
    tellOf(*analysed);
    if (!maps.empty()) {
        Result<Shot> shot = withGivenDepth(*analysed->shot, maps, control.part(0.9, 0.95));
        if (!shot)
            return shot.error();
        analysed->shot = std::make_shared<const Shot>(std::move(*shot));
    }
    if (Result<void> packable = checkPackable(*analysed, a); !packable)
        return packable.error();
    ClipReference reference{storedPath(a.input, a.output), info.frameCount, info.width, info.height,
                            info.framesPerSecond,          analysed->digest};
    return projectOf(std::move(reference), analysed->shot, a.input.filename().string(), a.packs);
}

} // namespace

ExitCode runAnalyseCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("analyse"),
        QStringLiteral("Finds how a filmed scene moves and writes it into a project.\n\n"
                       "CLIP: a video file, or a folder of pictures in name order. Says how much "
                       "of the camera's movement was found, and what that limits.\n\n"
                       "Motion and depth are kept in the cache ($XDG_CACHE_HOME/ductus/clips), which is safe "
                       "to delete: they are found again when needed. A run that was stopped goes on "
                       "where it was."));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The project to write."), QStringLiteral("P.ductus"));
    parser.addPositional(QStringLiteral("CLIP"), QStringLiteral("The clip."));
    const QCommandLineOption pack(QStringLiteral("pack"),
                                  QStringLiteral("Put motion and depth into the project as well, to give it "
                                                 "away. For short clips: about a megabyte a frame."));
    const QCommandLineOption depth(
        QStringLiteral("depth"),
        QStringLiteral("Depth maps made elsewhere, one a frame in name order: 16-bit grey PNG, EXR or NPY; "
                       "depth along the view in any unit, 0 where it is not known. They stay with the "
                       "project."),
        QStringLiteral("DIR"));
    const QCommandLineOption cameras(
        QStringLiteral("cameras"),
        QStringLiteral("Cameras found elsewhere: JSON (see the manual) or the folder of a COLMAP text model "
                       "with every frame."),
        QStringLiteral("FILE"));
    const QCommandLineOption model(QStringLiteral("model"),
                                   QStringLiteral("A depth network; not built into this program. Run it "
                                                  "elsewhere and give what it finds with --depth."),
                                   QStringLiteral("ONNX"));
    for (const QCommandLineOption &option : {output, pack, depth, cameras, model})
        parser.addOption(option);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::filesystem::path input = parser.positionalPath(0), target = parser.path(output);
    if (!hasExtension(target, ".ductus"))
        return parser.wrongUsage(QStringLiteral("-o P.ductus is missing"));
    TerminalJob job(parser.isQuiet());
    if (parser.isSet(model))
        return failed(job,
                      {ErrorCode::Unsupported, "Loading the depth network",
                       "this program has no networks built in",
                       "Run it elsewhere, write one depth map a frame and give their folder: --depth DIR",
                       parser.path(model).string()});
    if (Result<void> writable = checkWritable(target, writingProject); !writable)
        return failed(job, writable.error());
    const Result<Project> project = analysed(
        {input, target, parser.path(depth), parser.path(cameras), parser.isSet(pack)}, job.control());
    if (!project)
        return failed(job, project.error());
    job.control().progress(0.95, writingProject);
    const Result<SerializedProject> bytes = serializedProject(*project);
    if (!bytes)
        return failed(job, bytes.error());
    OutputFiles files;
    if (Result<void> added = files.add(target, bytes->bytes, writingProject); !added)
        return failed(job, added.error());
    if (Result<void> written = files.commit(); !written)
        return failed(job, written.error());
    job.control().progress(1.0, "Done");
    job.finishLine();
    if (const auto content = doodleOf(*project); content && !parser.isQuiet()) {
        const KnowledgeWords words = knowledgeWords(*(*content)->shot());
        std::fprintf(stderr, "%s %s\n", words.mode.c_str(), words.limit.c_str());
    }
    return ExitCode::Done;
}

} // namespace ductus
