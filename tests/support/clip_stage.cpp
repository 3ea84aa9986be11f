#include "support/clip_stage.h"

#include <cmath>

namespace ductus {

ClipTexture calmTexture(std::uint32_t seed, unsigned rgb, double patchSize, double contrast)
{
    const auto channel = [&](int shift) { return float(rgb >> shift & 255) / 255.0f; };
    return {seed, {channel(16), channel(8), channel(0)}, contrast, patchSize};
}

ClipPanel uprightPanel(const Vec3 &centre, double halfWidth, double halfHeight, const ClipTexture &texture)
{
    return {centre, {halfWidth, 0, 0}, {0, halfHeight, 0}, false, texture};
}

ClipPanel discPanel(const Vec3 &centre, double radius, const ClipTexture &texture)
{
    return {centre, {radius, 0, 0}, {0, radius, 0}, true, texture};
}

ClipPanel groundPanel(double y, double halfWidth, double zFrom, double zTo, const ClipTexture &texture)
{
    return {{0, y, 0.5 * (zFrom + zTo)}, {halfWidth, 0, 0}, {0, 0, 0.5 * (zTo - zFrom)}, false, texture};
}

ClipBody boxBody(const Vec3 &centre, const Vec3 &half, double turn, const ClipTexture &texture)
{
    const Eigen::Isometry3d place = Eigen::Translation3d(centre) * Eigen::AngleAxisd(turn, Vec3::UnitY());
    ClipBody body;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            ClipTexture own = texture;
            own.seed += std::uint32_t(2 * axis) + (side > 0.0);
            // Sides differ by more than the fixed light of the renderer makes them differ.
            own.colour *= axis == 0 ? 0.82f : axis == 1 ? 1.12f : 1.0f;
            body.panels.push_back({place * Vec3(side * half[axis] * Vec3::Unit(axis)),
                                   place.linear() * Vec3(half[u] * Vec3::Unit(u)),
                                   place.linear() * Vec3(half[v] * Vec3::Unit(v)), false, own});
        }
    return body;
}

std::function<ShotCamera(int)> cameraPath(const ClipScene &scene, const Vec3 &from, const Vec3 &to,
                                          double turnFrom, double turnTo, double down)
{
    const int width = scene.width, height = scene.height, last = std::max(1, scene.frameCount - 1);
    return [=](int frame) {
        const double share = double(frame) / last;
        const double sway = (to - from).norm() > 0.0 ? 1.0 : 0.0;
        ShotCamera camera;
        camera.focal = 0.95 * width;
        camera.centre = Vec2(0.5 * width, 0.5 * height);
        camera.worldFromCamera =
            Eigen::Translation3d(
                Vec3(from + share * (to - from) +
                     sway * Vec3(0.0, 0.012 * std::sin(9.0 * share), 0.015 * std::sin(5.0 * share + 1.0)))) *
            Eigen::AngleAxisd(turnFrom + share * (turnTo - turnFrom), Vec3::UnitY()) *
            Eigen::AngleAxisd(-down, Vec3::UnitX());
        return camera;
    };
}

} // namespace ductus
