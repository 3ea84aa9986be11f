#include "cli/thumbnail_output.h"

#include "cli/output_files.h"
#include "formats/png_file.h"

namespace ductus {

ThumbnailOptions::ThumbnailOptions(const QString &sizeMeaning)
    : output({QStringLiteral("o"), QStringLiteral("output")}, QStringLiteral("The picture."),
             QStringLiteral("OUT.png")),
      size(QStringLiteral("size"), sizeMeaning + QStringLiteral(" Default: 256."), QStringLiteral("N"),
           QStringLiteral("256"))
{
}

ExitCode writeThumbnail(const BatchParser &parser, const ThumbnailOptions &options, const DrawThumbnail &draw)
{
    const std::filesystem::path target = parser.path(options.output);
    if (target.empty() || !hasExtension(target, ".png"))
        return parser.wrongUsage(QStringLiteral("-o OUT.png is missing"));
    bool isSize = false;
    const int pixels = parser.value(options.size).toInt(&isSize);
    if (!isSize || pixels < 16 || pixels > 16384)
        return parser.wrongUsage(QStringLiteral("--size takes a whole number from 16 to 16384"));
    TerminalJob job(parser.isQuiet());
    if (Result<void> writable = checkWritable(target, "Writing the thumbnail"); !writable)
        return failed(job, writable.error());
    const Result<Image> image = draw(pixels, job.control());
    if (!image)
        return failed(job, image.error());
    if (Result<void> written = writePng(*image, target); !written)
        return failed(job, written.error());
    job.finishLine();
    return ExitCode::Done;
}

} // namespace ductus
