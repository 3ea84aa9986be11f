// The sound of a clip, decoded whole: 16-bit samples to play, and how loud it is over time to draw.
#pragma once

#include "base/job_control.h"
#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ductus {

struct ClipSound
{
    int sampleRate = 0;                // samples a second and channel
    int channels = 0;                  // 1 or 2
    std::vector<std::int16_t> samples; // channels interleaved
    /// When the first sample is heard, seconds from the first picture; may be negative.
    double startSeconds = 0.0;

    bool isEmpty() const { return samples.empty(); }
    double durationSeconds() const;
    /// The loudest sample between two moments of the clip, 0..1.
    double peak(double fromSeconds, double toSeconds) const;
};

struct SoundOptions
{
    double longestSeconds = 900.0; // what is after that stays silent: memory is bounded
};

/// Empty for clips without sound and folders of pictures. FileNotFound, Unsupported (no decoder), Malformed.
Result<ClipSound> readSound(const std::filesystem::path &path, const SoundOptions &options,
                            const JobControl &control);

} // namespace ductus
