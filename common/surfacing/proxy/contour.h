// The zero set of a field as a triangle mesh: marching tetrahedra on a narrow band of grid cubes, followed from
// seeds, so that all components near the strokes are found and empty space is never evaluated.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <functional>

namespace ductus {

struct ContourOptions
{
    double cellSize = 0.0;      // edge of a grid cube; must be > 0
    int maxCells = 3'000'000;   // cubes visited before giving up with TooLarge
    int edgeRefinements = 2;    // secant steps a mesh vertex
};

using ScalarField = std::function<double(const Vec3 &)>;

/// The surface field = 0, normals towards growing field. \a box bounds the search: a surface that leaves it is open
/// there. \a seeds: points near which the surface is looked for. Vertices are not evenly spaced: remesh afterwards.
/// The field is called from several threads.
Result<TriangleMesh> contourFromSeeds(const ScalarField &field, const std::vector<Vec3> &seeds, const Box3 &box,
                                      const ContourOptions &options, const JobControl &control);

} // namespace ductus
