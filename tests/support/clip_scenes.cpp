#include "support/clip_scenes.h"

#include <cmath>

namespace ductus {

namespace {

// World: x right, y down, z away from the first camera, metres. The floor is at y = 1.2, the back wall at
// z = 7.
constexpr double floorY = 1.2, ceilingY = -1.8, wallX = 3.5, backZ = 7.0, frontZ = -3.0;

ClipTexture texture(std::uint32_t seed, const Eigen::Vector3f &colour, double patchSize = 0.3)
{
    return {seed, colour, 1.0, patchSize};
}

ClipBody room()
{
    const double middleY = 0.5 * (floorY + ceilingY), halfY = 0.5 * (floorY - ceilingY);
    const double middleZ = 0.5 * (backZ + frontZ), halfZ = 0.5 * (backZ - frontZ);
    ClipBody body;
    body.panels = {
        {{0, floorY, middleZ}, {wallX, 0, 0}, {0, 0, halfZ}, false, texture(1, {0.55f, 0.42f, 0.3f}, 0.35)},
        {{0, ceilingY, middleZ}, {wallX, 0, 0}, {0, 0, halfZ}, false, texture(2, {0.8f, 0.8f, 0.78f}, 0.5)},
        {{-wallX, middleY, middleZ}, {0, 0, halfZ}, {0, halfY, 0}, false, texture(3, {0.5f, 0.6f, 0.5f})},
        {{wallX, middleY, middleZ}, {0, 0, halfZ}, {0, halfY, 0}, false, texture(4, {0.6f, 0.55f, 0.65f})},
        {{0, middleY, backZ}, {wallX, 0, 0}, {0, halfY, 0}, false, texture(5, {0.65f, 0.6f, 0.5f}, 0.4)}};
    return body;
}

// Six sides around the body's origin.
ClipBody box(const Vec3 &half, std::uint32_t seed, const Eigen::Vector3f &colour)
{
    ClipBody body;
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            body.panels.push_back({side * half[axis] * Vec3::Unit(axis), half[u] * Vec3::Unit(u),
                                   half[v] * Vec3::Unit(v), false,
                                   texture(seed + std::uint32_t(2 * axis) + (side > 0.0), colour, 0.16)});
        }
    return body;
}

ClipBody standing(ClipBody body, const Vec3 &place, double turn)
{
    const Eigen::Isometry3d worldFromBody =
        Eigen::Translation3d(place) * Eigen::AngleAxisd(turn, Vec3::UnitY());
    for (ClipPanel &panel : body.panels) {
        panel.centre = worldFromBody * panel.centre;
        panel.right = worldFromBody.linear() * panel.right;
        panel.down = worldFromBody.linear() * panel.down;
    }
    return body;
}

// Along a line from \a from to \a to over the clip, turning.
ClipBody sliding(ClipBody body, const Vec3 &from, const Vec3 &to, double turns, int frames)
{
    body.worldFromBody = [=](int frame) {
        const double share = frames > 1 ? double(frame) / (frames - 1) : 0.0;
        return Eigen::Isometry3d(Eigen::Translation3d(from + share * (to - from)) *
                                 Eigen::AngleAxisd(turns * share, Vec3::UnitY()));
    };
    return body;
}

ClipScene furnished(const std::string &name, int width, int height, int frames)
{
    ClipScene scene;
    scene.name = name;
    scene.width = width;
    scene.height = height;
    scene.frameCount = frames;
    scene.bodies = {room(), standing(box({0.45, 0.6, 0.4}, 20, {0.7f, 0.3f, 0.25f}), {-1.5, 0.6, 4.2}, 0.4),
                    standing(box({0.35, 0.35, 0.5}, 30, {0.25f, 0.4f, 0.7f}), {1.4, 0.85, 3.4}, -0.5),
                    standing(box({0.3, 1.0, 0.3}, 40, {0.3f, 0.6f, 0.3f}), {0.5, 0.2, 5.6}, 0.2)};
    ClipBody sign; // hangs in the air
    sign.panels = {
        {{-0.4, -0.7, 4.6}, {0.4, 0, 0.1}, {0, 0.4, 0}, true, texture(50, {0.8f, 0.7f, 0.2f}, 0.12)}};
    scene.bodies.push_back(sign);
    return scene;
}

// From the front wall into the room; \a from and \a to are places, \a turn is about the upright axis.
std::function<ShotCamera(int)> moving(int width, int height, int frames, const Vec3 &from, const Vec3 &to,
                                      double turnFrom, double turnTo)
{
    return [=](int frame) {
        const double share = frames > 1 ? double(frame) / (frames - 1) : 0.0;
        ShotCamera camera;
        camera.focal = 0.95 * width;
        camera.centre = Vec2(0.5 * width, 0.5 * height);
        // A hand never moves quite evenly.
        const Vec3 sway(0.0, 0.015 * std::sin(9.0 * share), 0.02 * std::sin(5.0 * share + 1.0));
        const bool moves = (to - from).norm() > 0.0;
        camera.worldFromCamera =
            Eigen::Translation3d(Vec3(from + share * (to - from) + (moves ? sway : Vec3::Zero()))) *
            Eigen::AngleAxisd(turnFrom + share * (turnTo - turnFrom), Vec3::UnitY()) *
            Eigen::AngleAxisd(-0.08, Vec3::UnitX());
        return camera;
    };
}

} // namespace

ClipScene sidewaysScene(int width, int height, int frames)
{
    ClipScene scene = furnished("sideways", width, height, frames);
    scene.camera = moving(width, height, frames, {-0.6, 0, 0}, {0.6, 0, 0}, 0.06, -0.08);
    return scene;
}

ClipScene forwardScene(int width, int height, int frames)
{
    ClipScene scene = furnished("forward", width, height, frames);
    scene.camera = moving(width, height, frames, {-0.2, 0, -1.0}, {0.2, 0, 0.8}, 0.0, 0.05);
    return scene;
}

ClipScene passingScene(int width, int height, int frames)
{
    ClipScene scene = furnished("passing", width, height, frames);
    scene.camera = moving(width, height, frames, {-0.4, 0, 0}, {0.4, 0, 0}, 0.04, -0.04);
    scene.bodies.push_back(standing(box({0.14, 1.5, 0.14}, 60, {0.45f, 0.3f, 0.2f}), {0.1, -0.3, 2.2}, 0.1));
    scene.bodies.push_back(sliding(box({0.35, 0.4, 0.3}, 70, {0.8f, 0.75f, 0.7f}), {-1.2, 0.8, 3.2},
                                   {1.2, 0.8, 3.0}, 0.3, frames));
    return scene;
}

ClipScene panScene(int width, int height, int frames)
{
    ClipScene scene = furnished("pan", width, height, frames);
    scene.camera = moving(width, height, frames, Vec3::Zero(), Vec3::Zero(), -0.2, 0.2);
    scene.bodies.push_back(sliding(box({0.3, 0.35, 0.3}, 80, {0.8f, 0.75f, 0.7f}), {-0.9, 0.85, 3.0},
                                   {1.0, 0.85, 3.0}, 0.4, frames));
    return scene;
}

ClipScene tripodScene(int width, int height, int frames)
{
    ClipScene scene = furnished("tripod", width, height, frames);
    scene.camera = moving(width, height, frames, Vec3::Zero(), Vec3::Zero(), 0.0, 0.0);
    scene.bodies.push_back(sliding(box({0.3, 0.35, 0.3}, 80, {0.8f, 0.75f, 0.7f}), {-0.9, 0.85, 2.6},
                                   {0.9, 0.85, 2.6}, 0.4, frames));
    scene.bodies.push_back(sliding(box({0.3, 0.6, 0.3}, 90, {0.2f, 0.25f, 0.6f}), {0.9, 0.6, 4.2},
                                   {-0.9, 0.6, 4.0}, 0.0, frames));
    return scene;
}

ClipScene fastScene(int width, int height, int frames)
{
    ClipScene scene = furnished("fast", width, height, frames);
    scene.camera = moving(width, height, frames, {-1.4, 0, -0.2}, {1.4, 0, 0.2}, 0.3, -0.3);
    scene.bodies.push_back(sliding(box({0.35, 0.35, 0.35}, 80, {0.8f, 0.75f, 0.7f}), {2.0, 0.85, 3.2},
                                   {-2.0, 0.85, 2.6}, 2.0, frames));
    return scene;
}

std::vector<ClipScene> allClipScenes(int width, int height, int frames)
{
    return {sidewaysScene(width, height, frames), forwardScene(width, height, frames),
            passingScene(width, height, frames),  panScene(width, height, frames),
            tripodScene(width, height, frames),   fastScene(width, height, frames)};
}

} // namespace ductus
