// From labels of a simplified graph back to the proxy: borders that had to follow the edges of clusters are
// made short again on the whole graph, near where they are.
#pragma once

#include "surfacing/segmentation/graph_simplification.h"

namespace ductus {

/// \a fit of the simplified graph as one of the whole graph.
ModelLabeling onWholeGraph(const LabelGraph &whole, const SimplifiedGraph &graph, ModelLabeling fit,
                           const SegmentationOptions &options);

/// Labels improved within a few edges of borders, models kept where no vertex changes.
Result<ModelLabeling> polished(const LabelGraph &whole, const SegmentationOptions &options, ModelLabeling fit,
                               const LabelConstraints &constraints, const JobControl &control);

} // namespace ductus
