// What the thumbnail commands of all apps share: where the picture goes, how large it is, and that nothing is
// left half written.
#pragma once

#include "base/result.h"
#include "cli/batch_command.h"
#include "imaging/image.h"

#include <functional>

namespace ductus {

struct ThumbnailOptions
{
    QCommandLineOption output;
    QCommandLineOption size;

    /// \a sizeMeaning: the help of --size, without its default.
    explicit ThumbnailOptions(const QString &sizeMeaning);
};

/// A picture whose longer side has so many pixels.
using DrawThumbnail = std::function<Result<Image>(int longerSide, const JobControl &control)>;

/// Draws the picture and writes it, after \a parser has read \a options among the rest. Wrong usage and
/// errors are told.
ExitCode writeThumbnail(const BatchParser &parser, const ThumbnailOptions &options,
                        const DrawThumbnail &draw);

} // namespace ductus
