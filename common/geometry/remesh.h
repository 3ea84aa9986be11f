// Even triangles (isotropic remeshing) and repair of meshes made elsewhere.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

struct RemeshOptions
{
    double targetEdgeLength = 0.0; // in mesh units; must be > 0
    int iterations = 3;
    double creaseAngleDegrees = 0.0; // edges sharper than this keep their line; 0 keeps none
};

/// A mesh with nearly equal edges that follows \a mesh, which must be an oriented manifold without repeated
/// corners (else InvalidArgument: repair first). Genus, components, borders and creases are kept: their lines
/// are split, and thinned where they run straight, never moved. Evenness yields where the input bends too
/// sharply for the target length: no step takes the surface farther than a tenth of it off a vertex. Asks for
/// cancellation four times an iteration. Deterministic. [Botsch, Kobbelt 2004]
Result<TriangleMesh> remeshed(const TriangleMesh &mesh, const RemeshOptions &options,
                              const JobControl &control);

struct RepairReport
{
    int mergedVertices = 0;
    int removedTriangles = 0; // degenerate, duplicate, or in the way of a manifold
    int splitVertices = 0;    // non-manifold vertices duplicated
    int reorientedTriangles = 0;
    bool selfIntersecting = false; // what remains; told, not mended
};

/// A manifold, consistently oriented version of \a mesh (closed components outwards): merges equal vertices,
/// drops degenerate and duplicate triangles, splits non-manifold edges and vertices. Refuses with NoSolution
/// and the reason when too little is left (less than half of the area), TooLittleData when nothing is.
Result<TriangleMesh> repaired(const TriangleMesh &mesh, RepairReport *report = nullptr);

} // namespace ductus
