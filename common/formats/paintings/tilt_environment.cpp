#include "formats/paintings/tilt_environment.h"

#include "imaging/picture/colour.h"

namespace ductus {

namespace {

struct Preset
{
    const char *id;
    const char *name;
    Rgba sky;
};

constexpr Preset presets[] = {{"ab080599-e465-4a6d-8587-43bf495af68b", "Standard", {40, 40, 52, 255}},
                              {"c504347a-c96d-4505-853b-87b484acff9a", "Night Sky", {11, 6, 24, 255}},
                              {"96cf6f36-47b6-44f4-bdbf-63be2ddac909", "Space", {0, 0, 0, 255}},
                              {"e2e72b76-d443-4721-97e6-f3d49fe98dda", "Dress Form", {56, 58, 81, 255}},
                              {"ab080511-e465-4a6d-8587-53bf495af68b", "Pedestal", {56, 58, 81, 255}},
                              {"ab080511-e565-4a6d-8587-53bf495af68b", "Snowman", {156, 176, 214, 255}},
                              {"36e65e4f-17d7-41ef-834a-e525db0b9888", "Pink Lemonade", {237, 150, 131, 255}},
                              {"a9bc2bc8-6d86-4cda-82a9-283e0f3977ac", "Pistachio", {186, 166, 116, 255}},
                              {"e65cde1a-a177-4bfb-b93f-f673c99a32bc", "Illustrative", {177, 177, 177, 255}},
                              {"580b4529-ac50-4fe9-b8d2-635765a14893", "Black", {0, 0, 0, 255}},
                              {"9b89b0a4-c41e-4b78-82a1-22f10a238357", "White", {200, 200, 200, 255}},
                              {"0ca88298-e5e8-4e94-aad8-4b4f6c80ae52", "Blue", {69, 79, 120, 255}}};

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
            return TiltEnvironment{preset.name, picture::linearFromRgba(preset.sky).cast<float>()};
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
