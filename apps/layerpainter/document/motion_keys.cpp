#include "layerpainter/document/motion_keys.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace ductus {

namespace {

const MotionGroup *findGroup(const Painting &painting, MotionGroupId id)
{
    const auto found = std::ranges::find(painting.motionGroups, id, &MotionGroup::id);
    return found == painting.motionGroups.end() ? nullptr : &*found;
}

bool isSameTime(const PlacementKey &key, double seconds)
{
    return std::abs(key.timeSeconds - seconds) < sameKeySeconds;
}

} // namespace

const PlacementKeys *keysOf(const Painting &painting, const MovedThing &thing)
{
    if (const auto *layer = std::get_if<LayerId>(&thing)) {
        const Layer *found = painting.findLayer(*layer);
        return found ? &found->motion : nullptr;
    }
    const MotionGroup *found = findGroup(painting, std::get<MotionGroupId>(thing));
    return found ? &found->keys : nullptr;
}

std::string nameOf(const Painting &painting, const MovedThing &thing)
{
    if (const auto *layer = std::get_if<LayerId>(&thing)) {
        const Layer *found = painting.findLayer(*layer);
        return found ? found->name : std::string();
    }
    const MotionGroup *found = findGroup(painting, std::get<MotionGroupId>(thing));
    return found ? found->name : std::string();
}

std::vector<ElementId> elementsOf(const Painting &painting, const MovedThing &thing, double seconds)
{
    if (const auto *group = std::get_if<MotionGroupId>(&thing)) {
        const MotionGroup *found = findGroup(painting, *group);
        return found ? found->elements : std::vector<ElementId>();
    }
    std::vector<ElementId> ids;
    if (const Layer *layer = painting.findLayer(std::get<LayerId>(thing)))
        for (const Element &element : layer->drawingAt(loopedTime(seconds, painting.loopSeconds)).elements)
            ids.push_back(element.id);
    return ids;
}

bool hasKeyAt(const PlacementKeys &keys, double seconds)
{
    return std::ranges::any_of(keys, [&](const PlacementKey &key) { return isSameTime(key, seconds); });
}

PlacementKeys withKey(PlacementKeys keys, double seconds, const Placement &placement)
{
    if (keys.empty() && seconds >= sameKeySeconds)
        keys.push_back({0, {}, KeyInterpolation::Smooth});
    PlacementKey made{seconds, placement, KeyInterpolation::Smooth};
    for (const PlacementKey &key : keys)
        if (isSameTime(key, seconds)) {
            made.timeSeconds = key.timeSeconds;
            made.interpolation = key.interpolation;
        }
    std::erase_if(keys, [&](const PlacementKey &key) { return isSameTime(key, seconds); });
    keys.insert(std::ranges::upper_bound(keys, made.timeSeconds, {}, &PlacementKey::timeSeconds), made);
    return keys;
}

PlacementKeys withoutKey(PlacementKeys keys, double seconds)
{
    std::erase_if(keys, [&](const PlacementKey &key) { return isSameTime(key, seconds); });
    return keys;
}

PaintingAction settingKeys(const MovedThing &thing, PlacementKeys keys)
{
    if (const auto *layer = std::get_if<LayerId>(&thing))
        return act::SetLayerMotion{*layer, std::move(keys)};
    return act::SetGroupMotion{std::get<MotionGroupId>(thing), std::move(keys)};
}

} // namespace ductus
