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
    static constexpr std::size_t count = (2 * reach + 1) * (2 * reach + 1);
    std::array<Eigen::Vector3f, count> colours;
    std::array<float, count> weights;

    /// From the middle, pixels.
    static Vec2 offsetOf(std::size_t place)
    {
        return step * Vec2(double(place % (2 * reach + 1)) - reach, double(place / (2 * reach + 1)) - reach);
    }
};

Patch patchAt(const SmallPicture &picture, const Vec2 &pixel);

/// How different the picture looks there: 0 for the same, grey levels, at most 40. \a warp: how offsets from
/// the middle have turned and grown since.
double differenceAt(const SmallPicture &picture, const Vec2 &pixel, const Patch &patch,
                    const Eigen::Matrix2d &warp = Eigen::Matrix2d::Identity());

} // namespace ductus
