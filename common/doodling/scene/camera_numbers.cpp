#include "doodling/scene/camera_numbers.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int mostRounds = 64; // two or three do
// Rotations are kept in such steps: coarse beside rounding errors, so that these cannot change them, and far
// finer than anything that is measured.
constexpr double steps = 4398046511104.0; // 2^42

Eigen::Quaterniond inSteps(const Eigen::Quaterniond &rotation)
{
    Eigen::Quaterniond result;
    result.coeffs() = (rotation.coeffs().array() * steps).round() / steps;
    return result;
}

} // namespace

std::array<double, numbersACamera> numbersOf(const ShotCamera &camera)
{
    const Eigen::Quaterniond rotation = inSteps(Eigen::Quaterniond(camera.worldFromCamera.linear()));
    const Vec3 position = camera.position();
    return {rotation.x(), rotation.y(), rotation.z(), rotation.w(),      position.x(),
            position.y(), position.z(), camera.focal, camera.centre.x(), camera.centre.y()};
}

std::optional<ShotCamera> cameraOf(std::span<const double, numbersACamera> n)
{
    const Eigen::Quaterniond rotation(n[3], n[0], n[1], n[2]);
    const bool isFinite =
        std::all_of(n.begin(), n.end(), [](double number) { return std::isfinite(number); });
    if (!isFinite || !(std::abs(rotation.norm() - 1.0) < 1e-6) || !(n[7] > 0.0))
        return std::nullopt;
    ShotCamera camera;
    camera.worldFromCamera.linear() = inSteps(rotation).normalized().toRotationMatrix();
    camera.worldFromCamera.translation() = Vec3(n[4], n[5], n[6]);
    camera.focal = n[7];
    camera.centre = Vec2(n[8], n[9]);
    return camera;
}

ShotCamera storable(const ShotCamera &camera)
{
    ShotCamera last = camera;
    for (int round = 0; round < mostRounds; ++round) {
        const std::optional<ShotCamera> next = cameraOf(numbersOf(last));
        if (!next || next->worldFromCamera.matrix() == last.worldFromCamera.matrix())
            return last;
        last = *next;
    }
    return last;
}

} // namespace ductus
