// Clip: one filmed shot, frame by frame. A video file of any kind FFmpeg reads, or a folder of pictures in
// name order. Frames are decoded when asked for, never held all together. They stand upright: the rotation a
// phone notes beside the video is applied.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "imaging/image.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ductus {

struct ClipInfo
{
    int frameCount = 0;
    int width = 0, height = 0;      // upright
    double framesPerSecond = 0.0;   // mean over the clip
    std::vector<double> frameTimes; // seconds from the first frame, one a frame; steps need not be even
    int rotationDegrees = 0;        // clockwise, applied to the stored frames: 0, 90, 180, 270
    bool hasAudio = false;
    std::string codec;                 // FFmpeg's name: "h264", "mjpeg"
    std::vector<std::string> warnings; // "the file ends in the middle of a frame"
};

class Clip
{
public:
    virtual ~Clip() = default;
    virtual const ClipInfo &info() const = 0;
    /// Frame \a index of 0..frameCount-1, scaled to at most \a mostLines lines (0: as it is). Going forwards
    /// is fast; anywhere else costs decoding from the key frame before.
    virtual Result<Image> frame(int index, int mostLines = 0) = 0;
};

/// Reads through the file once to know its frames. FileNotFound, PermissionDenied, Unsupported (no video in
/// it), Malformed (no frame can be decoded).
Result<std::unique_ptr<Clip>> openClip(const std::filesystem::path &path, const JobControl &control);

/// The size of a frame scaled to at most \a mostLines lines; whole even numbers.
std::pair<int, int> scaledSize(int width, int height, int mostLines);

} // namespace ductus
