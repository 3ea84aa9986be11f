// A proxy pulled to strokes that changed, and left alone elsewhere, so that labels and regions far away stay
// what they are.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"
#include "surfacing/sketch/symmetry_plane.h"

#include <optional>

namespace ductus {

struct LocalAttractionOptions
{
    double full = 0.1;         // up to this distance from the change the proxy follows its strokes ...
    double none = 0.25;        // ... from this on it stays. Shares of the box diagonal
    double maxDistance = 0.08; // strokes further away do not pull
};

/// \a strokes: all of them, unit frame, even steps, the solved half as is \a proxy. \a changed: points of the
/// changed strokes, not empty. Fails with NoSolution if the proxy would fold over.
Result<TriangleMesh> attractedNear(const TriangleMesh &proxy, const StrokeSet &strokes,
                                   const std::vector<Vec3> &changed,
                                   const std::optional<SymmetryPlane> &plane,
                                   const LocalAttractionOptions &options, const JobControl &control);

} // namespace ductus
