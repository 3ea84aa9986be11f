#include "doodling/tracking/support_motion.h"

#include "base/parallel.h"
#include "doodling/tracking/motion_between.h"
#include "doodling/tracking/patch.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double border = 2.0;      // pixels: support points keep off it
constexpr double mostMotion = 20.0; // pixels a frame: of a difference
constexpr double mostMiss = 20.0;   // pixels
constexpr int robustRounds = 6;
constexpr double rigidity = 12.0; // pixels: support within it says little about turn and growth
constexpr double likelyTurn =
    0.04; // radians a frame: points further off move by more, and are of the thing yet

struct SupportPoint
{
    Vec2 offset = Vec2::Zero(); // from the point, in the keyframe
    std::vector<FollowedPixel> followed;
    double weight = 0.0;
};

double colourDistance2(const Eigen::Vector3f &a, const Eigen::Vector3f &b)
{
    const Eigen::Vector3f d = a - b;
    return 0.5 * d.x() * d.x() + 2.0 * d.y() * d.y() + 2.0 * d.z() * d.z();
}

// Mean difference of the paths a frame, in the first frames.
double motionDistance(const SupportPoint &support, const PixelKeyframe &keyframe,
                      const std::vector<FollowedPixel> &followed, int frames)
{
    double sum = 0.0, weights = 0.0;
    for (int i = 1; i <= std::min(frames, int(followed.size()) - 1); ++i) {
        const FollowedPixel &own = followed[std::size_t(i)], &other = support.followed[std::size_t(i)];
        const double weight = 1.0 / (1.0 + own.variance + other.variance);
        const double difference = (other.pixel - own.pixel - support.offset).norm();
        sum += weight * std::min(difference / i, mostMotion);
        weights += weight;
    }
    return weights > 0.0 ? sum / weights : 0.0;
}

std::vector<SupportPoint> supportPoints(const Shot &shot, const PixelKeyframe &keyframe, int end,
                                        const std::vector<FollowedPixel> &followed,
                                        const SupportOptions &options)
{
    std::vector<SupportPoint> points;
    const int reach = int(options.radius / options.spacing);
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const Vec2 offset = options.spacing * Vec2(x, y), pixel = keyframe.pixel + offset;
            if (offset.norm() <= options.radius && pixel.x() > border && pixel.y() > border &&
                pixel.x() < shot.width - border && pixel.y() < shot.height - border)
                points.push_back({offset, {}, 0.0});
        }
    FollowOptions follow;
    follow.gaps = options.gaps;
    follow.stepDeviation = options.stepDeviation;
    parallelFor(
        0, points.size(),
        [&](std::size_t i) {
            SupportPoint &point = points[i];
            const PixelKeyframe start{keyframe.frame, keyframe.pixel + point.offset};
            point.followed = followPixel(shot, start, end, {}, follow);
            point.weight =
                std::exp(-point.offset.squaredNorm() / (2.0 * options.nearness * options.nearness));
            if (!shot.pictures.empty()) {
                const SmallPicture &picture = shot.pictures[std::size_t(keyframe.frame)];
                const double apart =
                    colourDistance2(picture.labAt(start.pixel), picture.labAt(keyframe.pixel));
                point.weight /= 1.0 + apart / (options.alikeColour * options.alikeColour);
            }
            const double moves = motionDistance(point, keyframe, followed, options.motionFrames);
            point.weight /=
                1.0 + std::pow(moves / (options.alikeMotion + likelyTurn * point.offset.norm()), 4);
        },
        8);
    return points;
}

// A similarity: shift, and (a, b) with offset -> offset + (a, -b; b, a) offset.
struct Similarity
{
    Vec2 shift = Vec2::Zero();
    double a = 0.0, b = 0.0;
    double spread = mostMiss; // pixels: how far support points are off

    Vec2 motionAt(const Vec2 &offset) const
    {
        return shift + Vec2(a * offset.x() - b * offset.y(), b * offset.x() + a * offset.y());
    }
};

// Least squares reweighted so that points that went with something else lose their say. \a fit is where the
// frame before ended: what turns is followed from frame to frame, by one leap it would look like an outlier.
Similarity similarityOf(const std::vector<SupportPoint> &points, const PixelKeyframe &keyframe,
                        std::size_t step, Similarity fit, const SupportOptions &options)
{
    for (int round = 0; round < robustRounds; ++round) {
        Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
        Eigen::Vector4d right = Eigen::Vector4d::Zero();
        double weights = 0.0, misses = 0.0;
        for (const SupportPoint &point : points) {
            const FollowedPixel &followed = point.followed[step];
            const Vec2 &x = point.offset, motion = followed.pixel - keyframe.pixel - x;
            const double miss = (motion - fit.motionAt(x)).norm();
            double weight = point.weight / (1.0 + followed.variance);
            const double scale = round > 0 ? options.outlierPixels : 2.0 * options.outlierPixels;
            weight /= std::pow(1.0 + std::pow(miss / scale, 2), 2);
            misses += weight * std::pow(std::min(miss, mostMiss), 2);
            weights += weight;
            Eigen::Matrix<double, 2, 4> row;
            row << 1.0, 0.0, x.x(), -x.y(), 0.0, 1.0, x.y(), x.x();
            normal += weight * row.transpose() * row;
            right += weight * row.transpose() * motion;
        }
        if (!(weights > 1e-12))
            return fit;
        normal.diagonal() += weights * Eigen::Vector4d(1e-9, 1e-9, rigidity * rigidity, rigidity * rigidity);
        const Eigen::Vector4d solution = normal.ldlt().solve(right);
        fit = {solution.head<2>(), solution[2], solution[3], std::sqrt(misses / weights)};
    }
    return fit;
}

} // namespace

Eigen::Matrix2d SupportMotion::warpAt(std::size_t step) const
{
    return growths[step] * Eigen::Rotation2Dd(turns[step]).toRotationMatrix();
}

SupportMotion supportMotion(const Shot &shot, const PixelKeyframe &keyframe, int end,
                            const std::vector<FollowedPixel> &followed, const SupportOptions &options)
{
    const std::vector<SupportPoint> points = supportPoints(shot, keyframe, end, followed, options);
    SupportMotion motion;
    const std::size_t count = followed.size();
    motion.places.assign(count, {keyframe.pixel, options.leastDeviation});
    motion.turns.assign(count, 0.0);
    motion.growths.assign(count, 1.0);
    Similarity fit;
    for (std::size_t i = 1; i < count; ++i) {
        fit = similarityOf(points, keyframe, i, fit, options);
        motion.places[i] = {keptNear(shot, keyframe.pixel + fit.shift), options.leastDeviation + fit.spread};
        motion.turns[i] = std::atan2(fit.b, 1.0 + fit.a);
        motion.growths[i] = std::hypot(1.0 + fit.a, fit.b);
    }
    return motion;
}

} // namespace ductus
