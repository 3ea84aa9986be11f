// Where elements stand at a time.
#pragma once

#include "painting/scene/painting.h"

#include <unordered_map>

namespace ductus {

/// Scene from element at one time of the painting (looped as the painting says): the element's own placement,
/// then its layer's motion, then that of the group it belongs to (of the first, should there be several).
class ElementPlacements
{
public:
    ElementPlacements(const Painting &painting, double timeSeconds);

    Placement sceneFromElement(const Layer &layer, const Element &element) const;

    /// The time inside the loop.
    double timeSeconds() const { return mTimeSeconds; }

private:
    double mTimeSeconds;
    std::unordered_map<std::int32_t, Placement> mGroupOfElement;
};

} // namespace ductus
