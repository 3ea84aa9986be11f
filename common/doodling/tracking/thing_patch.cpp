#include "doodling/tracking/thing_patch.h"

#include "doodling/tracking/motion_between.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double alikeMotion = 0.7; // pixels a frame: half weight
constexpr int longestGap = 8;       // frames: turns of the thing itself tell more and more beyond it

// How a place near a keyframe moves otherwise than it: pixels a frame, mean over what flow there is.
double otherMotion(const Shot &shot, const PixelKeyframe &keyframe, const Vec2 &pixel,
                   const std::vector<int> &gaps)
{
    double sum = 0.0;
    int count = 0;
    for (int gap : gaps)
        for (int other : {keyframe.frame - gap, keyframe.frame + gap}) {
            if (gap > longestGap || other < 0 || other >= shot.frameCount())
                continue;
            const std::optional<MotionAt> own = motionBetween(shot, keyframe.frame, other, keyframe.pixel),
                                          there = motionBetween(shot, keyframe.frame, other, pixel);
            if (!own || !there)
                continue;
            sum += (there->motion - own->motion).norm() / gap;
            ++count;
        }
    return count > 0 ? sum / count : 0.0;
}

} // namespace

Patch thingPatchAt(const Shot &shot, const PixelKeyframe &keyframe)
{
    const std::vector<int> gaps = gapsOf(shot);
    Patch patch = patchAt(shot.pictures[std::size_t(keyframe.frame)], keyframe.pixel);
    for (std::size_t i = 0; i < Patch::count; ++i) {
        const double other = otherMotion(shot, keyframe, keyframe.pixel + Patch::offsetOf(i), gaps);
        patch.weights[i] /= float(1.0 + std::pow(other / alikeMotion, 2));
    }
    return patch;
}

} // namespace ductus
