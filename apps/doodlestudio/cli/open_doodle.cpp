#include "doodlestudio/cli/open_doodle.h"

#include "base/error_place.h"
#include "painting/storage/painting_content.h"
#include "project/project_reader.h"

namespace ductus {

Result<OpenedDoodle> openDoodle(const std::filesystem::path &path)
{
    ProjectReadOptions options;
    options.kinds = {doodleKind(), paintingKind()};
    Result<Project> project = openProject(path, options);
    if (!project)
        return placedIn(project.error(), path);
    const Result<std::shared_ptr<const DoodleContent>> content = doodleOf(*project);
    if (!content)
        return placedIn(content.error(), path);
    std::filesystem::path clip((*content)->clip().path);
    if (clip.is_relative()) // as seen from the project's folder
        clip = (path.parent_path() / clip).lexically_normal();
    return OpenedDoodle{std::move(*project), *content, std::move(clip)};
}

Result<std::unique_ptr<Clip>> openItsClip(const OpenedDoodle &doodle, const std::filesystem::path &instead,
                                          const JobControl &control)
{
    const std::filesystem::path &path = instead.empty() ? doodle.clip : instead;
    Result<std::unique_ptr<Clip>> clip = openClip(path, control);
    if (!clip) {
        Error error = clip.error();
        if (error.code == ErrorCode::FileNotFound && instead.empty())
            error.remedy = "Say where the clip is now: --clip CLIP";
        return error;
    }
    const ClipInfo &found = (*clip)->info();
    const ClipReference &known = doodle.content->clip();
    if (found.frameCount != known.frameCount || found.width != known.width || found.height != known.height)
        return Error{ErrorCode::InvalidArgument, "Opening the clip",
                     "it has " + std::to_string(found.frameCount) + " frames of " +
                         std::to_string(found.width) + " x " + std::to_string(found.height) +
                         ", the one that was drawn on has " + std::to_string(known.frameCount) + " of " +
                         std::to_string(known.width) + " x " + std::to_string(known.height),
                     "Name the clip the project was made of: --clip CLIP", path.string()};
    return clip;
}

} // namespace ductus
