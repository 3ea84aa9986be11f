// Edits of what belongs to the whole painting: background, camera, groups that move as one.
#pragma once

#include "painting/scene/painting.h"

namespace ductus {

/// Refused: a background outside 0..1, a negative loop.
Result<Painting> setScene(const Painting &painting, const Eigen::Vector3f &background, BlendSpace blendSpace,
                          double loopSeconds);

Result<Painting> setCameraKeys(const Painting &painting, const std::vector<CameraKey> &keys);

struct AddedGroup
{
    Painting painting;
    MotionGroupId group;
};

/// Refused: elements that are not there, keys out of order.
Result<AddedGroup> addMotionGroup(const Painting &painting, const std::string &name,
                                  const std::vector<ElementId> &elements,
                                  const std::vector<PlacementKey> &keys);
Result<Painting> setGroupKeys(const Painting &painting, MotionGroupId group,
                              const std::vector<PlacementKey> &keys);
Result<Painting> removeMotionGroup(const Painting &painting, MotionGroupId group);

} // namespace ductus
