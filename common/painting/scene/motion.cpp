#include "painting/scene/motion.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

/// Between keys \a before and before + 1, the share of the second.
struct Between
{
    std::size_t before = 0;
    double share = 0;
};

template <typename Key>
Between find(const std::vector<Key> &keys, double timeSeconds)
{
    const auto later = std::upper_bound(keys.begin(), keys.end(), timeSeconds,
                                        [](double time, const Key &key) { return time < key.timeSeconds; });
    if (later == keys.begin())
        return {};
    const std::size_t before = std::size_t(later - keys.begin()) - 1;
    if (later == keys.end() || keys[before].interpolation == KeyInterpolation::Hold)
        return {before, 0};
    const double t =
        (timeSeconds - keys[before].timeSeconds) / (later->timeSeconds - keys[before].timeSeconds);
    return {before, keys[before].interpolation == KeyInterpolation::Smooth ? t * t * (3 - 2 * t) : t};
}

} // namespace

Placement placementAt(const std::vector<PlacementKey> &keys, double timeSeconds)
{
    if (keys.empty())
        return {};
    const Between at = find(keys, timeSeconds);
    const Placement &a = keys[at.before].placement;
    if (at.share == 0)
        return a;
    const Placement &b = keys[at.before + 1].placement;
    Placement between;
    between.rotation = a.rotation.slerp(at.share, b.rotation).normalized();
    // Growing by equal factors in equal times; a mirroring has nothing between and is held.
    between.scale = a.scale * std::pow(b.scale / a.scale, at.share);
    between.mirrored = a.mirrored;
    between.translation = a.translation + at.share * (b.translation - a.translation);
    return between;
}

CameraKey cameraAt(const CameraPath &path, double timeSeconds)
{
    DUCTUS_ASSERT(!path.keys.empty());
    const Between at = find(path.keys, timeSeconds);
    CameraKey camera = path.keys[at.before];
    camera.timeSeconds = timeSeconds;
    if (at.share == 0)
        return camera;
    const CameraKey &next = path.keys[at.before + 1];
    camera.eye += at.share * (next.eye - camera.eye);
    camera.rotation = camera.rotation.slerp(at.share, next.rotation).normalized();
    camera.verticalViewDegrees += at.share * (next.verticalViewDegrees - camera.verticalViewDegrees);
    return camera;
}

double loopedTime(double timeSeconds, double loopSeconds)
{
    if (loopSeconds <= 0)
        return timeSeconds;
    const double rest = std::fmod(timeSeconds, loopSeconds);
    return rest < 0 ? rest + loopSeconds : rest;
}

} // namespace ductus
