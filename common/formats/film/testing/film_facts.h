// What is in a film, and its pictures back: for tests of what was written.
#pragma once

#include "base/result.h"
#include "imaging/image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ductus {

struct FilmFacts
{
    std::string videoCodec, pixelFormat, soundCodec; // FFmpeg's names; no sound: empty
    int width = 0, height = 0;
    int rateNumerator = 0, rateDenominator = 1; // as the file tells players
    bool isBt709 = false;
    std::vector<double> frameTimes;               // seconds on the file's clock
    double seconds = 0.0;                         // as the file tells players
    double soundBegins = 0.0, soundSeconds = 0.0; // from the packets
    std::vector<Image> frames;                    // decoded, with alpha where there is one
    std::vector<float> sound;                     // decoded, the first channel
    int soundRate = 0;                            // samples a second
};

Result<FilmFacts> filmFacts(const std::filesystem::path &path);

/// Mean absolute difference of the colour channels, 8 bit levels.
double meanDifference(const Image &a, const Image &b);

} // namespace ductus
