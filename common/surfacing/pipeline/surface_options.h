// The options of the whole chain: those of its stages, side by side.
#pragma once

#include "surfacing/association/association.h"
#include "surfacing/extraction/boundary_trim.h"
#include "surfacing/extraction/mesh_optimization.h"
#include "surfacing/parts/skeletal_strokes.h"
#include "surfacing/proxy/proxy.h"
#include "surfacing/segmentation/segmentation.h"
#include "surfacing/sketch/symmetry_plane.h"

namespace ductus {

enum class SymmetryMode { None, Given, Auto };

struct SurfaceOptions
{
    double resamplingStep = 0.008; // of strokes, share of the box diagonal
    SymmetryMode symmetry = SymmetryMode::None;
    SymmetryPlane symmetryPlane; // in input coordinates, for Given
    SymmetryOptions symmetryDetection;
    ProxyOptions proxy;
    AssociationOptions association;
    BoundaryTrimOptions trim;
    SegmentationOptions segmentation;
    MeshOptimizationOptions extraction;
    SkeletalOptions skeletal;
};

} // namespace ductus
