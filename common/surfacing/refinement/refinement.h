// Scribbles applied to the regions of a proxy, one after the other.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/nearest.h"
#include "surfacing/refinement/label_solution.h"
#include "surfacing/sketch/unit_frame.h"

namespace ductus {

struct ScribbleDomain
{
    const TriangleMesh &proxy; // unit frame, solved half
    const MeshTopology &topology;
    const NearestOnMesh &nearest;
    const Association &association;
    const UnitFrame &frame;
    const std::optional<SymmetryPlane> &plane; // unit frame
};

/// \a segmentation as what scribbles start from.
LabelSolution unscribbled(const ScribbleDomain &domain, Segmentation segmentation,
                          const SegmentationOptions &options);

/// The automatic regions with all \a scribbles applied. \a known (may be null): a solution of the same domain
/// and options; what it shares with \a scribbles is not solved again.
Result<std::shared_ptr<const LabelSolution>>
refine(const ScribbleDomain &domain, const std::shared_ptr<const LabelSolution> &known,
       const std::vector<Scribble> &scribbles, const SegmentationOptions &options, const JobControl &control);

} // namespace ductus
