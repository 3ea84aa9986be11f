#include "doodlestudio/cli/analyse_command.h"

#include "base/sha256.h"
#include "cli/batch_command.h"
#include "cli/output_files.h"
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
Project projectOf(ClipReference clip, std::shared_ptr<const Shot> shot, const std::string &name)
{
    const std::string seed = clip.path + "/" + std::to_string(clip.frameCount) + "/" +
                             std::to_string(clip.width) + "x" + std::to_string(clip.height);
    Random random(std::stoull(sha256Hex(std::as_bytes(std::span(seed))).substr(0, 16), nullptr, 16));
    Project project;
    project.generator = "DoodleStudio";
    project.id = Uuid::from(random);
    project.documents.push_back(newDocument(
        Uuid::from(random), name, std::make_shared<const DoodleContent>(std::move(clip), std::move(shot))));
    return project;
}

Result<Project> analysed(const std::filesystem::path &input, const std::filesystem::path &output,
                         const JobControl &control)
{
    Result<std::unique_ptr<Clip>> clip = openClip(input, control.part(0.0, 0.02));
    if (!clip)
        return clip.error();
    const ClipInfo &info = (*clip)->info();
    for (const std::string &warning : info.warnings)
        std::fprintf(stderr, "\ndoodlestudio: %s\n", warning.c_str());
    Result<Shot> shot = reconstructShot(**clip, {}, control.part(0.02, 0.95));
    if (!shot)
        return shot.error();
    ClipReference reference{storedPath(input, output), info.frameCount, info.width, info.height,
                            info.framesPerSecond};
    return projectOf(std::move(reference), std::make_shared<const Shot>(std::move(*shot)),
                     input.filename().string());
}

} // namespace

ExitCode runAnalyseCommand(const QStringList &arguments)
{
    BatchParser parser(
        QStringLiteral("analyse"),
        QStringLiteral("Finds how a filmed scene moves and writes it into a project.\n\n"
                       "CLIP: a video file, or a folder of pictures in name order. Says how much "
                       "of the camera's movement was found, and what that limits."));
    const QCommandLineOption output({QStringLiteral("o"), QStringLiteral("output")},
                                    QStringLiteral("The project to write."), QStringLiteral("P.ductus"));
    parser.addPositional(QStringLiteral("CLIP"), QStringLiteral("The clip."));
    parser.addOption(output);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    const std::filesystem::path input = parser.positionalPath(0), target = parser.path(output);
    if (!hasExtension(target, ".ductus"))
        return parser.wrongUsage(QStringLiteral("-o P.ductus is missing"));
    TerminalJob job(parser.isQuiet());
    if (Result<void> writable = checkWritable(target, writingProject); !writable)
        return failed(job, writable.error());
    const Result<Project> project = analysed(input, target, job.control());
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
