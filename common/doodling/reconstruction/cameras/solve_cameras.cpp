#include "doodling/reconstruction/cameras/solve_cameras.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double stillPixels = 1.0; // at 854 of width: further from its first place a track has moved
constexpr double stillOnTripod = 0.55;
constexpr double mostTurnOnTripod = 2.0; // pixels at 854 of width
constexpr std::size_t mostStarts = 2;
constexpr double goodExplained = 0.6; // no second start is tried
// To be called solved, the cameras must leave turning far behind.
constexpr double leastParallax = 1.5;      // pixels at 854 of width
constexpr double leastParallaxShare = 3.0; // of their own miss
constexpr double leastExplained = 0.25;
constexpr double farBetter = 3.0;        // than turning
constexpr double leastFrameShare = 0.12; // of a frame's tracks: else the path is lost there

double quantileOf(std::vector<double> values, double share)
{
    if (values.empty())
        return 0.0;
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double stillShareOf(const std::vector<PointTrack> &tracks, double mostPixels)
{
    double still = 0.0, all = 0.0;
    for (const PointTrack &track : tracks) {
        double furthest = 0.0;
        for (const Vec2 &pixel : track.pixels)
            furthest = std::max(furthest, (pixel - track.pixels.front()).norm());
        all += double(track.pixels.size());
        if (furthest <= mostPixels)
            still += double(track.pixels.size());
    }
    return all > 0.0 ? still / all : 1.0;
}

// How far apart the two explanations see the points that stand still: upper quartile, pixels.
double parallaxOf(const std::vector<PointTrack> &tracks, const CameraPath &moving, const CameraPath &turning)
{
    std::vector<double> misses;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        if (!moving.points[i])
            continue;
        const PointTrack &track = tracks[i];
        // Turning explains a short track by a direction of its own; what counts is what is left over its
        // whole length.
        Vec3 sum = Vec3::Zero();
        for (int t = track.firstFrame; t < track.endFrame(); ++t)
            sum += turning.cameras[std::size_t(t)].rayOf(track.at(t)).normalized();
        const HomogeneousPoint direction(sum.x(), sum.y(), sum.z(), 0.0);
        double furthest = 0.0;
        for (int t = track.firstFrame; t < track.endFrame(); ++t)
            if (const auto seen = projected(turning.cameras[std::size_t(t)], direction))
                furthest = std::max(furthest, (*seen - track.at(t)).norm());
        misses.push_back(furthest);
    }
    return quantileOf(std::move(misses), 0.75);
}

CameraPath bestMovingPath(const std::vector<PointTrack> &tracks, int frameCount, const ShotCamera &lens,
                          const CameraPathOptions &options, const JobControl &control)
{
    CameraPath best;
    const std::vector<FirstPair> pairs = firstPairs(tracks, frameCount, lens, control.part(0.0, 0.2));
    for (std::size_t i = 0; i < std::min(pairs.size(), mostStarts) && !control.isCancelled(); ++i) {
        control.progress(0.2 + 0.8 * double(i) / mostStarts, "Finding how the camera moved");
        CameraPath path = growCameraPath(tracks, frameCount, pairs[i], options, control);
        const bool isBetter =
            best.cameras.empty() || std::make_pair(path.isComplete(), path.explainedShare) >
                                        std::make_pair(best.isComplete(), best.explainedShare);
        if (isBetter)
            best = std::move(path);
        if (best.isComplete() && best.explainedShare > goodExplained)
            break;
    }
    return best;
}

// How far the picture's middle moves by turning.
double turnedPixels(const std::vector<ShotCamera> &cameras)
{
    double furthest = 0.0;
    for (const ShotCamera &camera : cameras) {
        const Eigen::Matrix3d turn =
            cameras.front().worldFromCamera.linear().transpose() * camera.worldFromCamera.linear();
        furthest = std::max(furthest, Eigen::AngleAxisd(turn).angle() * camera.focal);
    }
    return furthest;
}

// Where the path ends the camera stays as it was.
void fillUnknown(CameraPath &path)
{
    std::vector<ShotCamera> &cameras = path.cameras;
    for (std::size_t t = 1; t < cameras.size(); ++t)
        if (!path.isKnown[t] && path.isKnown[t - 1]) {
            cameras[t] = cameras[t - 1];
            path.isKnown[t] = true;
        }
    for (std::size_t t = cameras.size() - 1; t-- > 0;)
        if (!path.isKnown[t]) {
            cameras[t] = cameras[t + 1];
            path.isKnown[t] = true;
        }
}

} // namespace

CameraSolution solveCameras(const std::vector<PointTrack> &tracks, int frameCount, int width, int height,
                            const CameraPathOptions &options, const JobControl &control)
{
    CameraSolution solution;
    ShotCamera lens;
    lens.focal = options.likelyFocalShare * std::max(width, height);
    lens.centre = Vec2(0.5 * width, 0.5 * height);
    solution.cameras.assign(std::size_t(frameCount), lens);
    const double unit = std::max(1.0, width / 854.0);
    solution.stillShare = stillShareOf(tracks, stillPixels * unit);
    if (solution.stillShare >= stillOnTripod || frameCount < 2 || tracks.empty())
        return solution;
    control.progress(0.0, "Finding how the camera moved");
    CameraPath turning = growTurningPath(tracks, frameCount, lens, options, control.part(0.0, 0.3));
    fillUnknown(turning);
    CameraPath moving = bestMovingPath(tracks, frameCount, lens, options, control.part(0.3, 1.0));
    if (control.isCancelled())
        return solution;
    const CameraSolution standing = solution;
    solution.knowledge = CameraKnowledge::RotationOnly;
    solution.explainedShare = turning.explainedShare;
    solution.medianMiss = turning.medianMiss;
    if (!moving.cameras.empty())
        solution.parallax = parallaxOf(tracks, moving, turning);
    // Where turning explains next to nothing even a path that is shaky in places is nearer to the truth.
    const bool isSure = moving.explainedShare > leastExplained && moving.leastFrameShare > leastFrameShare;
    const bool isFarBetter = moving.explainedShare > farBetter * turning.explainedShare;
    const bool isSolved = !moving.cameras.empty() && moving.isComplete() && (isSure || isFarBetter) &&
                          moving.explainedShare > turning.explainedShare &&
                          solution.parallax > leastParallax * unit &&
                          solution.parallax > leastParallaxShare * moving.medianMiss;
    if (isSolved) {
        solution.knowledge = CameraKnowledge::SolvedCameras;
        solution.explainedShare = moving.explainedShare;
        solution.medianMiss = moving.medianMiss;
        solution.points = std::move(moving.points);
    }
    if (!isSolved && turnedPixels(turning.cameras) < mostTurnOnTripod * unit)
        return standing; // what moved in the picture was not the camera's doing
    solution.cameras = isSolved ? std::move(moving.cameras) : std::move(turning.cameras);
    return solution;
}

} // namespace ductus
