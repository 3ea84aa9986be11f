#include "painting/scene/element_placement.h"

namespace ductus {

ElementPlacements::ElementPlacements(const Painting &painting, double timeSeconds)
    : mTimeSeconds(loopedTime(timeSeconds, painting.loopSeconds))
{
    for (const MotionGroup &group : painting.motionGroups) {
        if (group.keys.empty())
            continue;
        const Placement placement = placementAt(group.keys, mTimeSeconds);
        for (const ElementId element : group.elements)
            mGroupOfElement.emplace(element.value, placement);
    }
}

Placement ElementPlacements::sceneFromElement(const Layer &layer, const Element &element) const
{
    Placement placement = layer.motion.empty() ? element.placement
                                               : placementAt(layer.motion, mTimeSeconds) * element.placement;
    if (const auto group = mGroupOfElement.find(element.id.value); group != mGroupOfElement.end())
        placement = group->second * placement;
    return placement;
}

} // namespace ductus
