// Keys of what moves as one, a layer or a group of strokes: read, set and taken away at a time.
#pragma once

#include "painting/action/action.h"
#include "painting/scene/painting.h"

#include <variant>

namespace ductus {

using MovedThing = std::variant<LayerId, MotionGroupId>;
using PlacementKeys = std::vector<PlacementKey>;

/// Null where the painting has no such layer or group.
const PlacementKeys *keysOf(const Painting &painting, const MovedThing &thing);
std::string nameOf(const Painting &painting, const MovedThing &thing);
/// Its strokes and meshes in the drawing of a time.
std::vector<ElementId> elementsOf(const Painting &painting, const MovedThing &thing, double seconds);

/// Times nearer than this are the same key's, seconds.
constexpr double sameKeySeconds = 1e-3;
bool hasKeyAt(const PlacementKeys &keys, double seconds);

/// \a placement becomes the key of the time, instead of one that is there. The first key of all also keeps
/// what was before: without one at the beginning nothing would move.
PlacementKeys withKey(PlacementKeys keys, double seconds, const Placement &placement);
PlacementKeys withoutKey(PlacementKeys keys, double seconds);

/// The action that gives \a thing these keys.
PaintingAction settingKeys(const MovedThing &thing, PlacementKeys keys);

} // namespace ductus
