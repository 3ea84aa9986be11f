#include "support/solids.h"

namespace ductus {

bool FeatureCurve::isClosed() const
{
    return points.size() > 2 && (points.front() - points.back()).norm() < 1e-9;
}

const std::vector<SolidEntry> &allSolids()
{
    static const std::vector<SolidEntry> entries{
        {"bevelled-box", [] { return bevelledBox(); }},
        {"can", [] { return can(); }},
        {"bottle", [] { return bottle(); }},
        {"table-lamp", [] { return tableLamp(); }},
        {"torus", [] { return torus(); }},
        {"ellipsoid", [] { return ellipsoid(); }},
        {"l-bracket", [] { return lBracket(); }},
        {"house", [] { return house(); }},
        {"saddle", [] { return saddle(); }},
        {"bent-leaf", [] { return bentLeaf(); }},
        {"computer-mouse", [] { return computerMouse(); }},
        {"car", [] { return car(); }},
        {"car-cut-arches", [] { return car({.cutArches = true}); }},
        {"iron", [] { return iron(); }},
    };
    return entries;
}

} // namespace ductus
