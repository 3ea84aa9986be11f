// FilmWriter: pictures one after another into a film. MP4 (H.264), WebM (VP9), an animated GIF, or a folder
// of numbered PNGs, with the sound of another film where the kind has sound.
//
//     Result<FilmWriter> film = FilmWriter::open("out.mp4", options);
//     for (...)
//         if (Result<void> added = film->add(image); !added) return added.error();
//     return film->finish();
//
// Everything is written beside the target under another name, which is removed unless finish() succeeded: a
// cancelled or failed film leaves nothing and an older one untouched.
#pragma once

#include "base/result.h"
#include "formats/film/frame_rate.h"
#include "imaging/image.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace ductus {

enum class FilmKind { Mp4, WebM, Gif, PngFolder };

/// From the extension: .mp4 (.m4v, .mov are Mp4 too), .webm, .gif; none and a folder's name: PngFolder.
/// Nothing for other extensions.
std::optional<FilmKind> filmKindOf(const std::filesystem::path &path);

struct FilmOptions
{
    FilmKind kind = FilmKind::Mp4;
    /// Of the pictures given, as they are to be seen: no rotation is noted in the file. H.264 needs even
    /// sides: an odd one grows by one pixel, the last column or row repeated. The other kinds keep odd sides.
    int width = 0, height = 0;
    FrameRate rate;
    /// Seconds of each frame from the first one, ascending; empty: evenly by rate. The last frame lasts
    /// 1 / rate. GIF counts time in 1/100 s and players show no more than 50 frames a second: times are
    /// rounded, and a frame less than 1/50 s after the one before is left out.
    std::vector<double> frameTimes;
    /// WebM, GIF (a pixel is there or not) and PNG keep transparency; MP4 has none: pictures are laid over
    /// background.
    bool keepsAlpha = false;
    Rgba background = {255, 255, 255, 255};
    /// A film whose sound is put under this one: copied as it is where the kind takes it (AAC and MP3 into
    /// MP4, Opus and Vorbis into WebM), else encoded anew. Cut at the film's end. Empty, or without sound:
    /// silent.
    std::filesystem::path soundFrom;
    /// The moment of that film this one begins with, seconds on the clock of its streams; none: its first
    /// video frame.
    std::optional<double> soundBegins;
    /// Constant rate factor: H.264 18 and VP9 28 are hard to tell from the original; more is smaller. 0:
    /// these.
    int quality = 0;
};

/// Where the pictures of one kind go. Given pictures have the options' size.
class FilmSink
{
public:
    virtual ~FilmSink() = default;
    virtual Result<void> add(const Image &image) = 0;
    virtual Result<void> finish() = 0;
};

class FilmWriter
{
public:
    /// InvalidArgument (sizes, rate, times), Unsupported (an encoder is missing), and what writing can meet
    /// (no such folder, no permission, full disk). A PngFolder may not exist yet, be empty or hold only
    /// pictures of an earlier film, which are replaced; else WriteFailed.
    static Result<FilmWriter> open(const std::filesystem::path &path, const FilmOptions &options);

    FilmWriter(FilmWriter &&) noexcept;
    ~FilmWriter();

    /// InvalidArgument for another size than the options', or more frames than they have times.
    Result<void> add(const Image &image);

    /// Ends the file and gives it its name. Nothing can be added afterwards. TooLittleData without frames.
    Result<void> finish();

    int frameCount() const { return mFrameCount; }

private:
    FilmWriter(FilmOptions options, std::unique_ptr<FilmSink> sink);

    FilmOptions mOptions;
    std::unique_ptr<FilmSink> mSink; // null once finished or failed
    int mFrameCount = 0;
};

} // namespace ductus
