// Halving meshes at a symmetry plane and putting the halves together again (thesis Sec. III.6).
#pragma once

#include "surfacing/extraction/seam_insertion.h"
#include "surfacing/sketch/symmetry_plane.h"

namespace ductus {

/// The part of \a mesh on the kept side, cut along the plane; the new border lies in it exactly.
TriangleMesh keptHalf(const TriangleMesh &mesh, const SymmetryPlane &plane);

/// Border vertices that lie in the plane.
std::vector<char> verticesInPlane(const TriangleMesh &mesh, const SymmetryPlane &plane);

struct MirroredMesh
{
    TriangleMesh mesh;               // the half, then the mirrored triangles with their corners turned
    std::vector<int> imageOfVertex;  // for each vertex of the half its mirror image; itself where \a inPlane
};

/// Welds the half to its mirror image at the vertices flagged \a inPlane.
MirroredMesh withMirrorImage(const TriangleMesh &half, const SymmetryPlane &plane, const std::vector<char> &inPlane);

} // namespace ductus
