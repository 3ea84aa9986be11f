#include "formats/film/film_writer.h"

#include "formats/film/film_sinks.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Writing the film";
constexpr int longestSide = 16384;

Error refused(const std::string &problem, const std::string &remedy = "")
{
    return {ErrorCode::InvalidArgument, attempted, problem, remedy, ""};
}

Result<void> check(const FilmOptions &options)
{
    const auto isSide = [](int pixels) { return pixels >= 1 && pixels <= longestSide; };
    if (!isSide(options.width) || !isSide(options.height))
        return refused("a film cannot be " + std::to_string(options.width) + " x " +
                           std::to_string(options.height) + " pixels",
                       "Choose sides of 1 to " + std::to_string(longestSide) + " pixels");
    if (options.rate.numerator < 1 || options.rate.denominator < 1)
        return refused("the frame rate is not positive");
    double before = -1.0;
    for (double time : options.frameTimes) {
        if (!std::isfinite(time) || time <= before)
            return refused("the times of the frames do not ascend from zero");
        before = time;
    }
    return {};
}

Image laidOver(const Image &image, const Rgba &background)
{
    Image result = image;
    for (std::size_t i = 0; i < result.pixels.size(); i += 4) {
        const int alpha = result.pixels[i + 3];
        if (alpha == 255)
            continue;
        for (std::size_t c = 0; c < 3; ++c)
            result.pixels[i + c] =
                std::uint8_t((result.pixels[i + c] * alpha + background[c] * (255 - alpha) + 127) / 255);
        result.pixels[i + 3] = 255;
    }
    return result;
}

Result<std::unique_ptr<FilmSink>> openSink(const std::filesystem::path &path, const FilmOptions &options)
{
    switch (options.kind) {
    case FilmKind::Mp4:
    case FilmKind::WebM:
        return openMovie(path, options);
    case FilmKind::Gif:
        return openGif(path, options);
    case FilmKind::PngFolder:
        return openPngFolder(path, options);
    }
    return refused("this kind of film is not known");
}

} // namespace

std::optional<FilmKind> filmKindOf(const std::filesystem::path &path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".mp4" || extension == ".m4v" || extension == ".mov")
        return FilmKind::Mp4;
    if (extension == ".webm")
        return FilmKind::WebM;
    if (extension == ".gif")
        return FilmKind::Gif;
    if (extension.empty() && !path.empty())
        return FilmKind::PngFolder;
    return std::nullopt;
}

FilmWriter::FilmWriter(FilmOptions options, std::unique_ptr<FilmSink> sink)
    : mOptions(std::move(options)), mSink(std::move(sink))
{
}

FilmWriter::FilmWriter(FilmWriter &&) noexcept = default;
FilmWriter::~FilmWriter() = default;

Result<FilmWriter> FilmWriter::open(const std::filesystem::path &path, const FilmOptions &options)
{
    if (Result<void> sound = check(options); !sound)
        return sound.error();
    FilmOptions used = options;
    if (used.kind == FilmKind::Mp4)
        used.keepsAlpha = false;
    Result<std::unique_ptr<FilmSink>> sink = openSink(path, used);
    if (!sink)
        return sink.error();
    return FilmWriter(std::move(used), std::move(*sink));
}

Result<void> FilmWriter::add(const Image &image)
{
    if (!mSink)
        return refused("the film has ended");
    if (image.width != mOptions.width || image.height != mOptions.height)
        return refused("frame " + std::to_string(mFrameCount) + " has another size than the film");
    if (!mOptions.frameTimes.empty() && std::size_t(mFrameCount) >= mOptions.frameTimes.size())
        return refused("there are more frames than times");
    Result<void> added =
        mOptions.keepsAlpha ? mSink->add(image) : mSink->add(laidOver(image, mOptions.background));
    if (!added)
        mSink.reset(); // removes what was written
    else
        ++mFrameCount;
    return added;
}

Result<void> FilmWriter::finish()
{
    if (!mSink)
        return refused("the film has ended");
    const std::unique_ptr<FilmSink> sink = std::move(mSink);
    if (mFrameCount == 0)
        return Error{ErrorCode::TooLittleData, attempted, "there is no frame in it", "", ""};
    return sink->finish();
}

} // namespace ductus
