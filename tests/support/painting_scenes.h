// Paintings made for tests, each about one rule of painting.md section 2, with a camera that shows it. The
// CPU reference is tested on their properties, other renderers against the reference.
#pragma once

#include "painting/reference/frame_camera.h"
#include "painting/reference/painting_solid.h"

#include <functional>
#include <string>
#include <vector>

namespace ductus {

/// Builds paintings without going through edits; ids count up.
class PaintingBuilder
{
public:
    /// A stack with its substrate; its place in Painting::stacks.
    int addStack(const std::string &name);
    Layer &substrate(int stack) { return *painting.stacks[std::size_t(stack)].substrate; }
    /// \a stack -1 is the scene stack. The reference is good until the next layer is added there.
    Layer &addLayer(int stack, const std::string &name);
    ElementId add(Layer &layer, ElementShape shape, const Placement &placement = {});
    LookId addLook(const std::string &name);
    MotionGroupId addGroup(const std::string &name, std::vector<ElementId> elements,
                           std::vector<PlacementKey> keys);

    Painting painting;
};

/// A stroke of even width and colour through points.
StrokeShape evenStroke(StrokeSection section, const std::vector<Eigen::Vector3f> &points, float halfWidth,
                       const Eigen::Vector3f &colour, float opacity = 1,
                       const Eigen::Vector3f &normal = Eigen::Vector3f::UnitZ());

/// A box of triangles.
MeshShape boxMesh(const Vec3 &min, const Vec3 &max, const Eigen::Vector3f &colour);

/// A ball of triangles, outwards.
MeshShape ballMesh(const Vec3 &centre, double radius, const Eigen::Vector3f &colour);

struct PaintingScene
{
    std::string name; // of files: lower-case, hyphens
    Painting painting;
    FrameCamera camera; // for 4:3 pictures
    PaintingMoment moment;
};

// One scene a rule. The flat substrate is a plate around 2 x 1.5 whose upper face is z = 0; the bumpy one is
// made of round strokes of radius 0.1 side by side, their ridges at z = 0. Cameras look down on them.
PaintingScene intersectionFromOutside();
PaintingScene cameraInsideAStroke();
PaintingScene selfOverlap();
PaintingScene strokeOrder();
PaintingScene opaqueStrokesInClearLayers();
/// The mark is a round stroke along x at height 0.05 with half width 0.1 and tolerance 0.08; view 0..4 are
/// five directions, 5 and 6 the two eyes of a head before it.
PaintingScene toleranceOnFlat(int view);
PaintingScene toleranceOnBumps(int view);
/// Strokes at heights 0.02, 0.06, 0.10 (at y = 0.5, 0, -0.5) above the plate, tolerance 0.08; ribbons, that
/// have no thickness.
PaintingScene toleranceReach();
PaintingScene toleranceOfView();
PaintingScene allSections();
PaintingScene mirroredElements();
PaintingScene hiddenLayers();
PaintingScene twoHundredStacks();
/// "linear", "spherical", "noise", "texture", "stroke-inside", "stroke-outside", "two" (of which one is
/// inverted).
PaintingScene masked(const std::string &mask);
/// A grey ramp and colours below bars of colours, all of one mode.
PaintingScene blended(BlendMode mode, BlendSpace space);
PaintingScene sceneStack();
PaintingScene dayAndNight(bool night);
PaintingScene planeAndShadow(double timeSeconds);
PaintingScene translucentSubstrates();
PaintingScene meshes();

/// All of them, views and modes included, with names that differ.
std::vector<PaintingScene> allPaintingScenes();

} // namespace ductus
