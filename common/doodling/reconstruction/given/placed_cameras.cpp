#include "doodling/reconstruction/given/placed_cameras.h"

#include "doodling/reconstruction/depth/scene_scale.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int mostSightings = 12; // of a track, evenly over it
constexpr double mostMiss = 2.0;  // pixels: of a point that stands still
constexpr double leastMove = 1e-9;
constexpr double mostTurnOnTripod = 2.0; // pixels

std::optional<HomogeneousPoint> pointOf(const PointTrack &track, const std::vector<ShotCamera> &cameras)
{
    const int middle = track.firstFrame + int(track.pixels.size()) / 2;
    const int step = std::max(1, int(track.pixels.size()) / mostSightings);
    std::vector<RaySighting> sightings;
    for (int t = track.firstFrame; t < track.endFrame(); t += step)
        if (t != middle)
            sightings.push_back({&cameras[std::size_t(t)], track.at(t), 1.0});
    const ShotCamera &camera = cameras[std::size_t(middle)];
    const InverseDepthFit fit = fitInverseDepth(camera, track.at(middle), sightings);
    const double spread = fit.information > 0.0 ? 1.0 / std::sqrt(fit.information) : 1e30;
    if (!(fit.miss < mostMiss) || !(fit.inverseDepth > 3.0 * spread))
        return std::nullopt;
    const Vec3 place = camera.unprojected(track.at(middle), 1.0 / fit.inverseDepth);
    return HomogeneousPoint(place.x(), place.y(), place.z(), 1.0);
}

CameraKnowledge knowledgeOf(const std::vector<ShotCamera> &cameras)
{
    double moved = 0.0, turned = 0.0;
    const ShotCamera &first = cameras.front();
    for (const ShotCamera &camera : cameras) {
        moved = std::max(moved, (camera.position() - first.position()).norm());
        const Eigen::Matrix3d turn =
            first.worldFromCamera.linear().transpose() * camera.worldFromCamera.linear();
        turned = std::max(turned, Eigen::AngleAxisd(turn).angle() * camera.focal);
    }
    if (moved > leastMove * std::max(1.0, first.position().norm()))
        return CameraKnowledge::SolvedCameras;
    return turned > mostTurnOnTripod ? CameraKnowledge::RotationOnly : CameraKnowledge::Tripod;
}

} // namespace

void placeGivenCameras(const std::vector<ShotCamera> &cameras, const std::vector<PointTrack> &tracks,
                       Shot &shot)
{
    shot.cameras.clear();
    for (ShotCamera camera : cameras) {
        camera.focal *= shot.scale();
        camera.centre *= shot.scale();
        shot.cameras.push_back(camera);
    }
    shot.knowledge = knowledgeOf(shot.cameras);
    std::vector<std::optional<HomogeneousPoint>> points;
    if (shot.knowledge == CameraKnowledge::SolvedCameras)
        for (const PointTrack &track : tracks)
            points.push_back(pointOf(track, shot.cameras));
    measureScene(points, shot);
}

} // namespace ductus
