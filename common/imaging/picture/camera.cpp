#include "imaging/picture/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus::picture {

namespace {

constexpr double radiansPerDegree = std::numbers::pi / 180.0;

// How far the points reach beyond the planes of a frustum with the eye at the origin: the point (x, y, z)
// with z towards the eye is inside if x - eyeX <= (eyeZ - z) * slope, hence x + z * slope <= eyeX + eyeZ *
// slope.
struct Reach
{
    double right = -1e300, left = -1e300, top = -1e300, bottom = -1e300, nearest = -1e300;

    void add(const Vec3 &p, double radius, double slopeX, double slopeY)
    {
        // A ball is inside when its centre is 'radius' inside each plane.
        const double rx = radius * std::hypot(1.0, slopeX);
        const double ry = radius * std::hypot(1.0, slopeY);
        right = std::max(right, p.x() + p.z() * slopeX + rx);
        left = std::max(left, -p.x() + p.z() * slopeX + rx);
        top = std::max(top, p.y() + p.z() * slopeY + ry);
        bottom = std::max(bottom, -p.y() + p.z() * slopeY + ry);
        nearest = std::max(nearest, p.z() + radius);
    }
};

} // namespace

Camera framedCamera(const Stage &stage, const PictureOptions &options)
{
    const double azimuth = options.azimuthDegrees * radiansPerDegree;
    const double elevation = options.elevationDegrees * radiansPerDegree;
    const Vec3 towardsEye(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                          std::cos(azimuth) * std::cos(elevation));
    const Vec3 right(std::cos(azimuth), 0.0, -std::sin(azimuth));
    const Vec3 up = towardsEye.cross(right);

    Camera camera;
    camera.eyeFromStage.row(0) = right;
    camera.eyeFromStage.row(1) = up;
    camera.eyeFromStage.row(2) = -towardsEye;
    const double samplesX = double(options.width) * options.supersampling;
    const double samplesY = double(options.height) * options.supersampling;
    camera.centreX = 0.5 * samplesX;
    camera.centreY = 0.5 * samplesY;
    const double slope = std::tan(0.5 * options.fieldOfViewDegrees * radiansPerDegree);
    camera.focalSamples = 0.5 * samplesY / slope;

    const double keep = 1.0 - 2.0 * options.margin;
    const double slopeY = slope * keep;
    const double slopeX = slope * keep * samplesX / samplesY;
    Reach reach;
    const auto add = [&](const Vec3 &p, double radius) {
        reach.add(Vec3(right.dot(p), up.dot(p), towardsEye.dot(p)), radius, slopeX, slopeY);
    };
    for (const StageTriangle &triangle : stage.triangles) {
        for (const Vec3 &corner : triangle.corners)
            add(corner, 0.0);
    }
    for (const StageTube &tube : stage.tubes) {
        add(tube.a, tube.radius);
        add(tube.b, tube.radius);
    }
    for (const Vec3 &p : stage.alsoInFrame)
        add(p, 0.0);
    if (stage.isEmpty() && stage.alsoInFrame.empty())
        add(Vec3::Zero(), 0.5);

    const double distance = std::max({(reach.right + reach.left) / (2.0 * slopeX),
                                      (reach.top + reach.bottom) / (2.0 * slopeY), reach.nearest + 0.1});
    const double x = 0.5 * (reach.right - reach.left);
    const double y = 0.5 * (reach.top - reach.bottom);
    camera.eyeInStage = x * right + y * up + distance * towardsEye;
    return camera;
}

} // namespace ductus::picture
