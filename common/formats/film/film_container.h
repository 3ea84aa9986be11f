// The file a film is written into, and what is said when that fails.
#pragma once

#include "base/error.h"
#include "formats/film/av_handles.h"

#include <filesystem>

namespace ductus {

/// Closes the file before its context goes; declared after the OutputPlace that removes it.
struct FilmContainerDeleter
{
    void operator()(AVFormatContext *container) const
    {
        if (container->pb)
            avio_closep(&container->pb);
        avformat_free_context(container);
    }
};

using FilmContainer = std::unique_ptr<AVFormatContext, FilmContainerDeleter>;

/// \a code of FFmpeg; a full disk gets its remedy.
inline Error filmWriteError(const std::string &problem, int code, const std::filesystem::path &path)
{
    return {ErrorCode::WriteFailed, "Writing the film", problem + " (" + avMessage(code) + ")",
            code == AVERROR(ENOSPC) ? "Free some space and try again" : "", path.string()};
}

} // namespace ductus
