// How thick a solid is, and how wide its gaps: from places all over its surface a ray is sent straight
// inwards (outwards) to the opposite side. The opposite side must lie about parallel, as that of a wall does:
// towards an edge a ray measures the edge and no wall.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <vector>

namespace ductus {

struct ThicknessOptions
{
    int samples = 30'000;             // places at least, spread by area; every triangle has one
    double largestTiltDegrees = 40.0; // of the opposite side against the ray
};

struct ThicknessSample
{
    Vec3 place = Vec3::Zero(); // on the surface
    Vec3 opposite = Vec3::Zero();
    double length = 0.0; // between the two
    double area = 0.0;   // of the surface this sample stands for
};

struct Thickness
{
    std::vector<ThicknessSample> walls; // thinnest first
    std::vector<ThicknessSample> gaps;  // narrowest first
    double area = 0.0;                  // of the whole surface

    /// Share of the surface whose wall is thinner than \a length.
    double shareThinnerThan(double length) const;
};

/// Of a closed, outwards oriented \a mesh, or of several that may overlap; lengths in its unit. Where solids
/// overlap nothing is measured. Deterministic. Error: only Cancelled.
Result<Thickness> thicknessOf(const TriangleMesh &mesh, const ThicknessOptions &options,
                              const JobControl &control);

} // namespace ductus
