// Motion: keyed placements of layers and groups of elements, a camera path, a loop.
#pragma once

#include "painting/scene/ids.h"
#include "painting/scene/placement.h"

#include <string>
#include <vector>

namespace ductus {

/// How the time between a key and the next is passed.
enum class KeyInterpolation { Hold, Linear, Smooth };

struct PlacementKey
{
    double timeSeconds = 0;
    Placement placement;
    KeyInterpolation interpolation = KeyInterpolation::Linear;
};

/// Elements of any layers that move as one: the plane and its shadows (Fig. V.9).
struct MotionGroup
{
    MotionGroupId id;
    std::string name;
    std::vector<ElementId> elements;
    std::vector<PlacementKey> keys; // times grow
};

struct CameraKey
{
    double timeSeconds = 0;
    Eigen::Vector3d eye = Eigen::Vector3d::Zero();
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); // the camera looks along its -z
    double verticalViewDegrees = 45;                              // 1..170
    KeyInterpolation interpolation = KeyInterpolation::Smooth;
};

struct CameraPath
{
    std::vector<CameraKey> keys; // times grow
};

/// The placement at a time: that of the first key before it, of the last behind it, between them turned along
/// the shorter arc. Identity without keys.
Placement placementAt(const std::vector<PlacementKey> &keys, double timeSeconds);

/// The camera at a time, in the same way; \a path has a key.
CameraKey cameraAt(const CameraPath &path, double timeSeconds);

/// \a timeSeconds inside 0..loopSeconds; unchanged if loopSeconds is 0.
double loopedTime(double timeSeconds, double loopSeconds);

} // namespace ductus
