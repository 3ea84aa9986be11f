// Ids of a painting's parts. All come from one counter (Painting::nextId) and are never used twice.
#pragma once

#include "base/typed_id.h"

namespace ductus {

using StackId = TypedId<struct StackIdTag>;
using LayerId = TypedId<struct LayerIdTag>;
using ElementId = TypedId<struct ElementIdTag>;
using LookId = TypedId<struct LookIdTag>;
using MotionGroupId = TypedId<struct MotionGroupIdTag>;
using PictureId = TypedId<struct PictureIdTag>;

} // namespace ductus
