#include "doodlestudio/cli/timeline_file.h"

#include "doodling/export/timeline_text.h"
#include "formats/atomic_file.h"

#include <span>

namespace ductus {

Result<void> writeTimelineFile(const OpenedDoodle &doodle, const std::filesystem::path &clip,
                               const std::filesystem::path &path)
{
    std::error_code error;
    const std::filesystem::path film = std::filesystem::absolute(clip.empty() ? doodle.clip : clip, error);
    const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
    const std::filesystem::path seen = film.lexically_relative(folder);
    const std::string text =
        timelineText(film.stem().string(), (seen.empty() ? film : seen).generic_string(),
                     doodle.content->clip(), *doodle.content->shot(), *doodle.content->scene());
    return writeFileAtomically(path, std::as_bytes(std::span(text)), "Writing the timeline");
}

} // namespace ductus
