// From the optimised (half) mesh in the unit frame to what the user gets: whole, in input coordinates, with
// regions, creases and deviations.
#pragma once

#include "surfacing/association/association.h"
#include "surfacing/extraction/mesh_optimization.h"
#include "surfacing/pipeline/surface_result.h"
#include "surfacing/sketch/unit_frame.h"

namespace ductus {

/// For border vertices outside the symmetry plane the nearest place on a border stroke, where one is near
/// (Eq. III.12). Strokes across the surface have no say: their ends would pull the border into spikes.
std::vector<BorderAttraction> borderTargets(const TriangleMesh &mesh, const StrokeSet &borderStrokes,
                                            const std::vector<char> &inPlane);

/// Regions of the whole mesh, one a triangle, from the labels of its (half) mesh: those of the mirrored side
/// are regions of their own unless they touch the plane. \a labelOfRegion receives one label a region.
std::vector<int> wholeRegions(const SeamedMesh &seamed, bool isMirrored, const std::vector<char> &inPlane,
                              int labelCount, std::vector<int> *labelOfRegion = nullptr);

void finishSurface(const StrokeSet &input, const UnitFrame &frame, const SeamedMesh &seamed,
                   const OptimizedMesh &optimized, const std::optional<SymmetryPlane> &plane,
                   const std::vector<char> &inPlane, const Association &association,
                   const StrokeSet &unitStrokes, SurfaceResult &result);

} // namespace ductus
