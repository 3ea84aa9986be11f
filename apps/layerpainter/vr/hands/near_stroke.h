// What the hand touches.
#pragma once

#include "painting/scene/painting.h"

#include <optional>

namespace ductus {

struct NearStroke
{
    ElementId element;
    LayerId layer;
    Eigen::Vector3f colour = Eigen::Vector3f::Zero(); // of its own there, linear RGB
    double distance = 0;                              // from its skin, scene units; 0 inside
};

/// The stroke at \a point (scene) within \a reach of its skin, at a moment; of strokes as near (such as those
/// that are all touched) one of \a preferred, then the last drawn. Hidden and locked layers are not touched.
std::optional<NearStroke> nearStroke(const Painting &painting, double seconds, const Eigen::Vector3d &point,
                                     double reach, LayerId preferred);

} // namespace ductus
