// Canvases: flat sheets in a filmed scene that are drawn on, and the scene that holds them.
#pragma once

#include "doodling/canvas/doodle.h"
#include "doodling/prop/prop.h"
#include "doodling/tracking/track_canvas.h"

namespace ductus {

using CanvasId = TypedId<struct CanvasIdTag>;

/// Static: stays where its first keyframes put it in the scene. Dynamic: follows what it was pinned to.
enum class CanvasMotion { Static, Dynamic };

/// "In front of me here": a line brushed over a frame which says whether the canvas is seen there, whatever
/// the depth says. It moves with what is filmed to frames nearby.
struct OcclusionTouch
{
    int frame = 0;
    std::vector<Vec2> line; // working pixels
    double radius = 8.0;    // working pixels
    bool isCanvasInFront = true;
    int reach = 6; // frames before and after in which it counts, less and less
};

/// How what is filmed hides a canvas.
struct CanvasOcclusion
{
    bool isOn = true;
    /// The scene hides the canvas where it is nearer by more than this share of the canvas' depth. More: the
    /// canvas shows through what is close to it; below zero: it sinks in earlier.
    double bias = 0.03;
    /// Over this share of the canvas' depth it fades from seen to hidden.
    double softness = 0.03;
    std::vector<OcclusionTouch> touches; // later ones cover earlier ones
};

struct Canvas
{
    CanvasId id;
    std::string name; // UTF-8
    CanvasMotion motion = CanvasMotion::Static;
    CanvasTurning turning = CanvasTurning::Still;
    Vec2 size = Vec2(1.0, 1.0); // scene units at scale 1; the sheet's edge, drawing may go beyond
    CanvasKeyframes keyframes;  // positions: at least one; see tracking/track_canvas.h
    Doodle doodle;
    std::shared_ptr<const Prop> prop; // stands on it, below what is drawn; may be null
    bool isVisible = true;
    double opacity = 1.0; // 0..1
    int shownFrom = 0;    // first video frame
    int shownUntil = -1;  // last video frame; -1: the clip's
    CanvasOcclusion occlusion;
};

/// Everything drawn into a shot. Canvases are painted by depth, the farthest first; the order here decides
/// between those equally far, the first lowest.
struct DoodleScene
{
    std::vector<Canvas> canvases;

    const Canvas *find(CanvasId id) const;
};

/// The canvas' place in every frame of \a shot: trackCanvas() for dynamic ones; static ones have the place,
/// turn and scale of their first keyframes in all frames.
Result<CanvasTrack> canvasTrack(const Shot &shot, const Canvas &canvas, const JobControl &control);

/// Whether \a canvas is to be painted in \a videoFrame as far as it decides by itself.
bool isShownIn(const Canvas &canvas, int videoFrame);

} // namespace ductus
