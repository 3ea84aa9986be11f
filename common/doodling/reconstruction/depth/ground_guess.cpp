#include "doodling/reconstruction/depth/ground_guess.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double horizonShare = 0.4;  // of the picture's height, from above: people film slightly downwards
constexpr double nearestShare = 0.5;  // of the scene's usual depth: the floor at the lower border
constexpr double backdropShare = 1.8; // how far the backdrop is

// Downwards in the world, on average over the clip; cameras are held upright.
Vec3 meanDown(const Shot &shot)
{
    Vec3 sum = Vec3::Zero(), ahead = Vec3::Zero();
    for (const ShotCamera &camera : shot.cameras) {
        sum += camera.worldFromCamera.linear().col(1);
        ahead += camera.worldFromCamera.linear().col(2);
    }
    const ShotCamera &lens = shot.cameras.front();
    const double tilt = std::atan((0.5 - horizonShare) * shot.height / lens.focal);
    const Vec3 side = sum.cross(ahead);
    if (side.norm() < 1e-9)
        return sum.norm() > 1e-9 ? Vec3(sum.normalized()) : Vec3(Vec3::UnitY());
    // About the axis to the side, so that the horizon is where it is guessed.
    return Eigen::AngleAxisd(tilt, side.normalized()) * sum.normalized();
}

} // namespace

std::vector<float> guessedDisparities(const Shot &shot, int frame, const CompactFlow &grid)
{
    const Vec3 down = meanDown(shot);
    const ShotCamera &camera = shot.cameras[std::size_t(frame)];
    const double steepest = (1.0 - horizonShare) * shot.height / camera.focal;
    const double cameraHeight = steepest * nearestShare * shot.sceneDepth;
    std::vector<float> disparities;
    disparities.reserve(grid.cellCount());
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const Vec3 ray = camera.rayOf(Vec2(x + 0.5, y + 0.5) * grid.cellSize);
            const double backdrop = ray.norm() / (backdropShare * shot.sceneDepth);
            disparities.push_back(float(std::max(backdrop, down.dot(ray) / cameraHeight)));
        }
    return disparities;
}

} // namespace ductus
