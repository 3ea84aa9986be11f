// A camera as ten numbers, as files keep it: rotation x y z w, position, focal length, centre of projection.
#pragma once

#include "doodling/scene/shot_camera.h"

#include <array>
#include <optional>
#include <span>

namespace ductus {

inline constexpr std::size_t numbersACamera = 10;

std::array<double, numbersACamera> numbersOf(const ShotCamera &camera);

/// Nothing if the numbers are none of a camera: not finite, no rotation, no focal length.
std::optional<ShotCamera> cameraOf(std::span<const double, numbersACamera> numbers);

/// \a camera moved by a rounding error so that writing and reading its numbers gives it back bit for bit:
/// what is found with it again is then the same.
ShotCamera storable(const ShotCamera &camera);

} // namespace ductus
