// The soft dark spot below a thing, so that it stands somewhere: how much of each place on the ground is
// covered, nearer parts darker, blurred.
#pragma once

#include "geometry/triangle_mesh.h"
#include "imaging/image.h"
#include "strokes/stroke.h"

namespace ductus {

struct GroundShadow
{
    Image image;                 // black with alpha; row 0 runs from corner along alongU
    Vec3 corner = Vec3::Zero();  // of the square on the ground, scene units
    Vec3 alongU = Vec3::UnitX(); // its edges
    Vec3 alongV = Vec3::UnitZ();
    double height = 0.0; // of the ground along the up axis

    bool isEmpty() const { return image.pixels.empty(); }
};

/// Of points spread over the thing (vertices of a mesh, points of strokes). Empty for less than three points.
GroundShadow groundShadow(const std::vector<Vec3> &points, UpAxis up, double darkest);

} // namespace ductus
