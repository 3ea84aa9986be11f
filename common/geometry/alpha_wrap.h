// A closed, outwards oriented manifold around anything: CGAL's 3D alpha wrapping of line segments
// [Portaneri, Rouxel-Labbe, Hemmer, Cohen-Steiner, Alliez 2022]. The lowest rung of the proxy ladder.
#pragma once

#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

struct AlphaWrapOptions
{
    double alpha = 0.0;  // size of the smallest hole that is entered, in input units; must be > 0
    double offset = 0.0; // distance kept from the input; must be > 0
};

/// Wraps the points (given as samples dense enough that alpha bridges them). Deterministic.
Result<TriangleMesh> alphaWrap(const std::vector<Vec3> &points, const AlphaWrapOptions &options);

} // namespace ductus
