// From the optimised (half) mesh in the unit frame to what the user gets: whole, in input coordinates, with
// regions, creases and deviations.
#pragma once

#include "surfacing/extraction/seam_insertion.h"
#include "surfacing/pipeline/surface_pipeline.h"
#include "surfacing/sketch/unit_frame.h"

namespace ductus {

/// For each border vertex outside the symmetry plane the nearest stroke point, if one is near (Eq. III.12).
std::vector<BorderAttraction> borderTargets(const TriangleMesh &mesh, const StrokeSet &strokes,
                                            const std::vector<char> &inPlane);

/// Distance of every vertex to the nearest stroke point; at most \a farthest.
std::vector<double> strokeDistances(const TriangleMesh &mesh, const StrokeSet &strokes, double farthest);

void finishSurface(const StrokeSet &input, const UnitFrame &frame, const SeamedMesh &seamed,
                   const OptimizedMesh &optimized, const std::optional<SymmetryPlane> &plane,
                   const std::vector<char> &inPlane, const Association &association, const StrokeSet &unitStrokes,
                   SurfaceResult &result);

} // namespace ductus
