#include "doodling/reconstruction/depth/scene_scale.h"

#include "doodling/scene/camera_numbers.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double beyondPoints = 1.6;  // how much nearer than the nearest points anything may be
constexpr double nearestGuess = 10.0; // times nearer than usual, where no points tell

struct DepthRange
{
    double usual = 0.0; // inverse depths
    double most = 0.0;  // nearer than all but a few
};

DepthRange rangeOf(std::vector<double> inverses)
{
    if (inverses.empty())
        return {};
    std::sort(inverses.begin(), inverses.end());
    return {inverses[inverses.size() / 2], inverses[std::size_t(0.98 * double(inverses.size() - 1))]};
}

// Of the points as the cameras see them.
DepthRange depthRange(const Shot &shot, const std::vector<std::optional<HomogeneousPoint>> &points)
{
    std::vector<double> inverses;
    for (int t = 0; t < shot.frameCount(); t += std::max(1, shot.frameCount() / 8))
        for (const auto &point : points) {
            if (!point || point->w() <= 1e-9 * point->norm())
                continue;
            const ShotCamera &camera = shot.cameras[std::size_t(t)];
            const Vec3 place = point->head<3>() / point->w();
            const std::optional<Vec2> seen = camera.projected(place);
            if (seen && seen->x() > 0 && seen->y() > 0 && seen->x() < shot.width && seen->y() < shot.height)
                inverses.push_back(1.0 / camera.depthOf(place));
        }
    return rangeOf(std::move(inverses));
}

} // namespace

void scaleScene(const std::vector<std::optional<HomogeneousPoint>> &points, Shot &shot)
{
    shot.nearestDisparity = nearestGuess / shot.sceneDepth;
    if (shot.knowledge == CameraKnowledge::SolvedCameras) {
        const DepthRange range = depthRange(shot, points);
        if (range.usual > 0.0) {
            for (ShotCamera &camera : shot.cameras)
                camera.worldFromCamera.translation() *= range.usual * shot.sceneDepth;
            shot.nearestDisparity = beyondPoints * range.most / (range.usual * shot.sceneDepth);
        }
    }
    for (ShotCamera &camera : shot.cameras)
        camera = storable(camera);
}

void measureScene(const std::vector<std::optional<HomogeneousPoint>> &points, Shot &shot)
{
    const DepthRange range =
        shot.knowledge == CameraKnowledge::SolvedCameras ? depthRange(shot, points) : DepthRange();
    if (range.usual > 0.0)
        shot.sceneDepth = 1.0 / range.usual;
    shot.nearestDisparity = range.usual > 0.0 ? beyondPoints * range.most : nearestGuess / shot.sceneDepth;
    for (ShotCamera &camera : shot.cameras)
        camera = storable(camera);
}

} // namespace ductus
