// Does a candidate proxy stand for the strokes? Checks that decide whether a rung of the ladder holds.
#pragma once

#include "geometry/triangle_mesh.h"

#include <optional>
#include <string>

namespace ductus {

struct ProxyQualityLimits
{
    double medianDistance = 0.015; // strokes to surface before attraction, share of the diagonal
    double p95Distance = 0.05;
    double areaRatio = 2.6;        // of the wrap's area: more means folds and stray sheets
};

/// Nothing if \a candidate is good, else the reason in words.
std::optional<std::string> proxyFault(const TriangleMesh &candidate, const TriangleMesh &wrap,
                                      const std::vector<Vec3> &strokePoints, const ProxyQualityLimits &limits);

/// Components no stroke lies on (nearest component of at least 3 % of the points) are dropped.
TriangleMesh withoutStrayComponents(const TriangleMesh &mesh, const std::vector<Vec3> &strokePoints);

} // namespace ductus
