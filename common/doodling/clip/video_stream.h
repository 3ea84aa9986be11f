// The video stream of a file: its packets' times and its decoder.
#pragma once

#include "base/result.h"
#include "formats/film/av_handles.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace ductus {

class VideoStream
{
public:
    static Result<VideoStream> open(const std::filesystem::path &path);

    const AVStream &stream() const { return *mFormat->streams[mIndex]; }
    const AVFormatContext &format() const { return *mFormat; }
    int rotationDegrees() const; // clockwise, to be applied

    /// Presentation times of all frames in the stream's time base, ascending. Reads through the file; goes
    /// back to its begin. \a isCut: the file ended within a packet.
    std::vector<std::int64_t> readTimes(bool *isCut);

    /// The next frame in order of presentation, null at the end. Frames that cannot be decoded are passed
    /// over.
    AVFrame *next();
    /// next() returns the first frame at or before \a time that can be decoded from there.
    bool seek(std::int64_t time);

private:
    VideoStream() = default;

    AvOwned<AVFormatContext> mFormat;
    AvOwned<AVCodecContext> mCodec;
    AvOwned<AVPacket> mPacket;
    AvOwned<AVFrame> mFrame;
    int mIndex = -1;
    bool mIsDraining = false;
};

} // namespace ductus
