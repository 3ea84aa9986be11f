#include "doodling/reconstruction/cameras/camera_record.h"

#include "base/sha256.h"
#include "doodling/scene/camera_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ductus {

namespace {

constexpr std::size_t factsBefore = 3; // knowledge, scene depth, nearest disparity

std::vector<double> factsOf(const Shot &shot)
{
    std::vector<double> facts{double(int(shot.knowledge)), shot.sceneDepth, shot.nearestDisparity};
    for (const ShotCamera &camera : shot.cameras)
        for (double number : numbersOf(camera))
            facts.push_back(number);
    return facts;
}

} // namespace

std::string cameraKey(const Shot &shot)
{
    std::string text;
    for (double number : factsOf(shot)) {
        char digits[40];
        // Rounded: what a project stores may differ in the last bit.
        std::snprintf(digits, sizeof digits, "%.9g ", std::abs(number) < 1e-9 ? 0.0 : number);
        text += digits;
    }
    return sha256Hex(std::as_bytes(std::span(text)));
}

Result<void> keepCameras(ShotStore &store, const Shot &shot)
{
    RecordWriter writer;
    writer.add<double>(factsOf(shot));
    const auto written = store.write(RecordKind::Cameras, 0, writer);
    return written ? Result<void>() : Result<void>(written.error());
}

bool takeCameras(ShotStore &store, int frameCount, Shot &shot)
{
    RecordReader reader(store.read(RecordKind::Cameras, 0));
    const std::vector<double> facts = reader.numbers();
    const std::size_t frames = std::size_t(frameCount);
    if (reader.failed() || facts.size() != factsBefore + numbersACamera * frames || !(facts[1] > 0.0))
        return false;
    std::vector<ShotCamera> cameras;
    for (std::size_t t = 0; t < frames; ++t) {
        const std::span<const double, numbersACamera> numbers(facts.data() + factsBefore + numbersACamera * t,
                                                              numbersACamera);
        const std::optional<ShotCamera> camera = cameraOf(numbers);
        if (!camera)
            return false;
        cameras.push_back(*camera);
    }
    shot.knowledge = CameraKnowledge(std::clamp(int(facts[0]), 0, int(CameraKnowledge::SolvedCameras)));
    shot.sceneDepth = facts[1];
    shot.nearestDisparity = facts[2];
    shot.cameras = std::move(cameras);
    return true;
}

} // namespace ductus
