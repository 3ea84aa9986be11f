// What a region of the proxy knows about its surface model (thesis Sec. III.5.3): the stroke points P_alpha
// it must pass through, and P'_alpha, the vertices far enough from strokes for the proxy's normals to be
// believed.
#pragma once

#include "surfacing/association/association.h"

namespace ductus {

struct RegionSupport
{
    std::vector<int> points;       // indices into Association::points, ascending
    std::vector<int> freeVertices; // indices into Association::vertices without stroke points, ascending
};

/// Of the vertices with flag set.
RegionSupport supportOf(const Association &association, const std::vector<char> &vertexFlags);

/// Of the vertices listed.
RegionSupport supportOf(const Association &association, const std::vector<int> &vertices);

RegionSupport united(const RegionSupport &a, const RegionSupport &b);

/// \a support must have points.
ImplicitPolynomial fitRegion(const Association &association, const RegionSupport &support, int degree,
                             const ModelFitOptions &options);

} // namespace ductus
