#include "formats/paintings/tilt_environment.h"

#include <array>
#include <cmath>

namespace ductus {

namespace {

struct Preset
{
    const char *id;
    const char *name;
    std::array<int, 3> sky; // sRGB
};

constexpr Preset presets[] = {{"ab080599-e465-4a6d-8587-43bf495af68b", "Standard", {40, 40, 52}},
                              {"c504347a-c96d-4505-853b-87b484acff9a", "Night Sky", {11, 6, 24}},
                              {"96cf6f36-47b6-44f4-bdbf-63be2ddac909", "Space", {0, 0, 0}},
                              {"e2e72b76-d443-4721-97e6-f3d49fe98dda", "Dress Form", {56, 58, 81}},
                              {"ab080511-e465-4a6d-8587-53bf495af68b", "Pedestal", {56, 58, 81}},
                              {"ab080511-e565-4a6d-8587-53bf495af68b", "Snowman", {156, 176, 214}},
                              {"36e65e4f-17d7-41ef-834a-e525db0b9888", "Pink Lemonade", {237, 150, 131}},
                              {"a9bc2bc8-6d86-4cda-82a9-283e0f3977ac", "Pistachio", {186, 166, 116}},
                              {"e65cde1a-a177-4bfb-b93f-f673c99a32bc", "Illustrative", {177, 177, 177}},
                              {"580b4529-ac50-4fe9-b8d2-635765a14893", "Black", {0, 0, 0}},
                              {"9b89b0a4-c41e-4b78-82a1-22f10a238357", "White", {200, 200, 200}},
                              {"0ca88298-e5e8-4e94-aad8-4b4f6c80ae52", "Blue", {69, 79, 120}}};

float linearFromByte(int value)
{
    const float x = float(value) / 255.f;
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

/// Near enough to sRGB to compare by.
Eigen::Vector3f perceived(const Eigen::Vector3f &linear)
{
    return linear.cwiseMax(0).array().sqrt();
}

constexpr float leastDifference = 0.12f; // of a channel, 0..1: a dark grey on black is seen

} // namespace

std::optional<TiltEnvironment> tiltEnvironment(std::string_view id)
{
    for (const Preset &preset : presets)
        if (id == preset.id)
            return TiltEnvironment{preset.name,
                                   {linearFromByte(preset.sky[0]), linearFromByte(preset.sky[1]),
                                    linearFromByte(preset.sky[2])}};
    return std::nullopt;
}

bool standsOutFrom(const PaintingFile &painting, const Eigen::Vector3f &linearBackground)
{
    const Eigen::Vector3f background = perceived(linearBackground);
    std::int64_t points = 0, seen = 0;
    for (const PaintingFileLayer &layer : painting.layers)
        for (const auto &drawing : layer.drawings)
            for (const PaintingFileStroke &stroke : drawing->strokes)
                for (const auto &point : stroke.points) {
                    ++points;
                    seen += (perceived(point.colour) - background).cwiseAbs().maxCoeff() >= leastDifference;
                }
    return 2 * seen >= points;
}

} // namespace ductus
