// The surroundings a .tilt was painted in: what its colours were chosen against.
#pragma once

#include "formats/painting_file.h"

#include <optional>
#include <string>
#include <string_view>

namespace ductus {

struct TiltEnvironment
{
    std::string name;
    Eigen::Vector3f sky; // linear RGB: the middle of its gradient
};

/// By EnvironmentPreset of metadata.json; none for others than the built-in ones. Ids and sky colours are
/// Open Brush's, as its web viewer lists them.
std::optional<TiltEnvironment> tiltEnvironment(std::string_view id);

/// Whether most of the painting is told apart from a background by its colour alone; true without strokes.
/// Tilt Brush lights its strokes, so that black ones on black are seen there; here they would not be.
bool standsOutFrom(const PaintingFile &painting, const Eigen::Vector3f &linearBackground);

} // namespace ductus
