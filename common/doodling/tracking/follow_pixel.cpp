#include "doodling/tracking/follow_pixel.h"

#include "doodling/tracking/motion_between.h"
#include "doodling/tracking/patch.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double alikeDistance = 2.0; // pixels: ways that end so near each other agree
constexpr double lostDeviations = 2.0;

// The ways that agree with the surest one, by their sureness.
FollowedPixel agreedOf(const std::vector<FollowedPixel> &ways)
{
    const FollowedPixel &best =
        *std::min_element(ways.begin(), ways.end(), [](const FollowedPixel &a, const FollowedPixel &b) {
            return a.variance < b.variance;
        });
    Vec2 sum = Vec2::Zero();
    double weights = 0.0;
    for (const FollowedPixel &way : ways)
        if ((way.pixel - best.pixel).norm() < alikeDistance + 0.5 * std::sqrt(best.variance)) {
            sum += way.pixel / way.variance;
            weights += 1.0 / way.variance;
        }
    return {sum / weights, best.variance};
}

FollowedPixel orExpected(const FollowedPixel &followed, const ExpectedPlace &expected)
{
    const double most = std::pow(lostDeviations * expected.deviation, 2);
    if (followed.variance <= most)
        return followed;
    const double a = 1.0 / followed.variance, b = 1.0 / most;
    return {(a * followed.pixel + b * expected.pixel) / (a + b), most};
}

} // namespace

std::vector<FollowedPixel> followPixel(const Shot &shot, const PixelKeyframe &keyframe, int end,
                                       const std::vector<ExpectedPlace> &expected,
                                       const FollowOptions &options)
{
    const int direction = end >= keyframe.frame ? 1 : -1, count = std::abs(end - keyframe.frame);
    const bool looks = options.differenceShare > 0.0 && !shot.pictures.empty();
    Patch patch;
    if (looks)
        patch = patchAt(shot.pictures[std::size_t(keyframe.frame)], keyframe.pixel);
    std::vector<FollowedPixel> followed(std::size_t(count) + 1);
    followed[0] = {keyframe.pixel, 0.0};
    std::vector<FollowedPixel> ways;
    for (int i = 1; i <= count; ++i) {
        const int frame = keyframe.frame + direction * i;
        ways.clear();
        for (int gap : options.gaps) {
            if (gap > i)
                break;
            const FollowedPixel &from = followed[std::size_t(i - gap)];
            const std::optional<MotionAt> motion =
                motionBetween(shot, frame - direction * gap, frame, from.pixel);
            if (!motion)
                continue;
            FollowedPixel way;
            way.pixel = keptNear(shot, from.pixel + motion->motion);
            way.variance = from.variance + std::pow(options.stepDeviation + missOf(*motion), 2);
            if (looks)
                way.variance +=
                    options.differenceShare *
                    std::pow(differenceAt(shot.pictures[std::size_t(frame)], way.pixel, patch), 2);
            if (!expected.empty()) {
                const ExpectedPlace &place = expected[std::size_t(i)];
                way.variance +=
                    options.expectedShare * std::pow((way.pixel - place.pixel).norm() / place.deviation, 4);
            }
            ways.push_back(way);
        }
        followed[std::size_t(i)] = agreedOf(ways);
        if (!expected.empty())
            followed[std::size_t(i)] = orExpected(followed[std::size_t(i)], expected[std::size_t(i)]);
    }
    return followed;
}

} // namespace ductus
