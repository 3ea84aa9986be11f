// What one scribble asks of the solver: new models, preferences of vertices (Eq. III.13), changed edges, and
// the labels to start from.
#pragma once

#include "surfacing/refinement/refinement.h"

namespace ductus {

struct ScribbleEffect
{
    ModelLabeling start;
    LabelConstraints constraints;     // of all scribbles up to this one
    std::vector<char> vertexIsLocked; // one a proxy vertex
};

/// Later scribbles win over earlier ones where they meet, except over locks: locked vertices take no part.
Result<ScribbleEffect> effectOf(const ScribbleDomain &domain, const LabelSolution &before,
                                const Scribble &scribble, const SegmentationOptions &options);

} // namespace ductus
