// Synthetic clips whose truth is known exactly: textured panels and boxes that stand or move before a moving
// camera, drawn by casting rays. Of every frame: picture, depth, where each pixel goes to until the next
// frame, whether it is seen there; of every point: its whole track with visibility.
#pragma once

#include "doodling/clip/clip.h"
#include "doodling/reconstruction/shot.h"
#include "doodling/scene/shot_camera.h"
#include "support/clip_texture.h"

#include <functional>
#include <memory>
#include <string>

namespace ductus {

/// A flat piece: centre + a * right + b * down for a, b in -1..1, or the disc in it.
struct ClipPanel
{
    Vec3 centre = Vec3::Zero(), right = Vec3::UnitX(), down = Vec3::UnitY();
    bool isRound = false;
    ClipTexture texture;
};

/// Panels that move together.
struct ClipBody
{
    std::vector<ClipPanel> panels;
    std::function<Eigen::Isometry3d(int frame)> worldFromBody; // none: it stands
};

struct ClipScene
{
    std::string name;
    int width = 320, height = 180, frameCount = 24;
    std::vector<ClipBody> bodies;
    std::function<ShotCamera(int frame)> camera;
};

/// What a frame shows; row by row, one entry a pixel, at the pixel's middle.
struct ClipTruth
{
    Image image;
    std::vector<float> depths;            // z, scene units
    std::vector<int> bodies;              // index in the scene, -1: nothing is there
    std::vector<Eigen::Vector2f> motions; // to the next frame, pixels; zero in the last one
    std::vector<bool> isSeenNext;         // in the next frame, too
};

ClipTruth renderedFrame(const ClipScene &scene, int frame);
/// The picture alone.
Image renderedImage(const ClipScene &scene, int frame);

struct ClipTrack
{
    std::vector<Vec2> pixels;    // one a frame; also where it is hidden
    std::vector<Vec3> positions; // world
    std::vector<double> depths;
    std::vector<bool> isVisible;
};

/// The point of the scene seen at \a pixel of \a frame; empty where nothing is seen.
ClipTrack trackOf(const ClipScene &scene, int frame, const Vec2 &pixel);

/// A clip that renders its frames when they are asked for.
std::unique_ptr<Clip> clipOf(const ClipScene &scene);

/// What a perfect reconstruction would say: true cameras, depth, flow and moving bodies (numbered from 1 in
/// the scene's order), on grids of \a cellSize pixels.
Shot trueShot(const ClipScene &scene, int cellSize = 4);

/// A room with boxes; the camera moves sideways and turns a little.
ClipScene sidewaysScene(int width, int height, int frames);
/// The same room; the camera walks into it.
ClipScene forwardScene(int width, int height, int frames);
/// The sideways camera; a box slides over the floor and passes behind a post.
ClipScene passingScene(int width, int height, int frames);
/// The camera turns on a tripod, a box slides.
ClipScene panScene(int width, int height, int frames);
/// The camera stands still, two boxes slide, the one before the other.
ClipScene tripodScene(int width, int height, int frames);
/// The sideways camera at four times the speed, a box that turns and slides as fast.
ClipScene fastScene(int width, int height, int frames);

std::vector<ClipScene> allClipScenes(int width, int height, int frames);

} // namespace ductus
