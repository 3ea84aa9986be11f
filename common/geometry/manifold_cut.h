// Makes a consistently oriented manifold of any triangles by cutting, after [Gueziec, Taubin, Lazarus, Horn
// 2001]: decide which two triangles stay joined at each edge, orient along those joints, then give every fan
// of triangles its own vertex.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

struct ManifoldCut
{
    TriangleMesh mesh;           // corners of a triangle may start with another of its vertices than before
    int splitVertices = 0;       // copies made
    int reorientedTriangles = 0; // turned over
};

/// \a mesh must have valid indices and no triangle with a repeated corner or twice. Positions stay as they
/// are: where more than two triangles share an edge those that continue each other most smoothly stay joined
/// (or, where solids touch, those of one solid); one-sided surfaces are cut open. Where two joints of one
/// edge would still share both ends, one of them gets an extra vertex in the middle. Closed components are
/// oriented outwards, open ones as most of their triangles were.
ManifoldCut cutToManifold(const TriangleMesh &mesh);

} // namespace ductus
