// What a place looks like, to tell whether another frame shows the same there: colours on a grid around it,
// the nearest counting most.
#pragma once

#include "doodling/reconstruction/small_picture.h"
#include "doodling/scene/shot_camera.h"

#include <array>

namespace ductus {

struct Patch
{
    static constexpr int reach = 2;     // places to each side
    static constexpr double step = 4.0; // pixels
    std::array<Eigen::Vector3f, (2 * reach + 1) * (2 * reach + 1)> colours;
};

Patch patchAt(const SmallPicture &picture, const Vec2 &pixel);

/// How different the picture looks there: 0 for the same, grey levels, at most 40.
double differenceAt(const SmallPicture &picture, const Vec2 &pixel, const Patch &patch);

} // namespace ductus
