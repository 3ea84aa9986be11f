// The two small fits structure from motion is made of: a camera before known points, and a point along the
// ray of one camera as seen by others. Both robust, both Gauss-Newton.
#pragma once

#include "doodling/scene/shot_camera.h"

#include <span>

namespace ductus {

/// xyz / w, so that points at infinity (w = 0) are points, too; w >= 0.
using HomogeneousPoint = Eigen::Vector4d;

struct PointSighting
{
    HomogeneousPoint point = HomogeneousPoint::Zero();
    Vec2 pixel = Vec2::Zero();
};

/// Nothing for points behind the camera.
std::optional<Vec2> projected(const ShotCamera &camera, const HomogeneousPoint &point);

struct CameraFit
{
    int inliers = 0;     // closer than three times the spread
    double spread = 0.0; // median distance in pixels
};

/// Turns and, unless \a isRotationOnly, moves \a camera to where the points are seen best. It should start
/// near; sightings that fit nowhere count hardly (Cauchy, \a scalePixels).
CameraFit fitCamera(ShotCamera &camera, std::span<const PointSighting> sightings, bool isRotationOnly,
                    double scalePixels = 1.0);

struct RaySighting
{
    const ShotCamera *camera = nullptr;
    Vec2 pixel = Vec2::Zero();
    double weight = 1.0;
};

struct InverseDepthFit
{
    double inverseDepth = 0.0; // 1 / scene unit; may be negative: then it is no place of a still scene
    double information = 0.0;  // squared pixels per squared inverse depth: one over its variance at 1 px
    double miss = 0.0;         // pixels, weighted mean of the robust distances
};

/// How far along the ray of \a pixel in \a camera the point is that the others saw. Linear in the inverse
/// depth up to the division, so that starting from \a start converges in a few steps.
InverseDepthFit fitInverseDepth(const ShotCamera &camera, const Vec2 &pixel,
                                std::span<const RaySighting> sightings, double start = 0.0,
                                double scalePixels = 1.0);

} // namespace ductus
