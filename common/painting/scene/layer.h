// Layers: substrates, which are the shape, and appearances, which only colour the substrate below them.
// painting.md section 1; thesis V.3.
#pragma once

#include "painting/blend/blend_mode.h"
#include "painting/scene/element.h"
#include "painting/scene/mask.h"
#include "painting/scene/motion.h"

#include <optional>
#include <string>

namespace ductus {

/// Surface: the reach is the same from every side. View: the difference of depth along the view, as in thesis
/// V.5.
enum class ToleranceMode { Surface, View };

/// What a look stores of a layer.
struct LayerProperties
{
    bool visible = true;
    double opacity = 1;                      // 0..1
    BlendMode blendMode = BlendMode::Normal; // of appearance layers; Normal in substrates
    std::optional<Eigen::Vector3f> colour;   // linear RGB for all elements instead of their own
    std::vector<Mask> masks;                 // of appearance layers; none in substrates
};

/// Elements in drawing order.
struct Drawing
{
    std::vector<Element> elements;
};

/// Frame-by-frame drawings stay frames. A still layer has one drawing and one frame.
struct LayerFrames
{
    double framesPerSecond = 24;
    int repeatCount = 0; // 0: for ever
    std::vector<int> drawingOfFrame{0};
};

struct Layer
{
    LayerId id;
    std::string name; // UTF-8
    bool locked = false;
    LayerProperties properties;
    double tolerance = 0; // d, scene units, >= 0; of appearance layers
    ToleranceMode toleranceMode = ToleranceMode::Surface;
    std::vector<Drawing> drawings{Drawing{}}; // at least one
    LayerFrames frames;
    std::vector<PlacementKey> motion; // times grow

    /// The drawing shown at a time: the last frame's after all repeats.
    const Drawing &drawingAt(double timeSeconds) const;
    int elementCount() const;
};

} // namespace ductus
