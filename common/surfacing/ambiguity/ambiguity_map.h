// Where plausible segmentations of a sketch disagree: there the sketch says too little, and a stroke or a
// scribble more would help (surfacing.md section 1, ambiguity map; thesis Sec. III.9).
#pragma once

#include "surfacing/ambiguity/label_samples.h"

namespace ductus {

struct AmbiguityMapOptions
{
    double borderTolerance = 0.02; // borders this near to one another are the same, share of the box diagonal
    double surfaceScale = 0.01; // standard deviation of the surface that counts as fully ambiguous, likewise
};

/// One value a proxy vertex, 0: all agree, 1: as undecided as can be.
struct AmbiguityMap
{
    std::vector<double> border;  // is there a border nearby? 1 where half of the samples (by weight) say so
    std::vector<double> surface; // where does the surface run?
    std::vector<double> either;  // the larger of the two
};

/// \a proxy: unit frame. \a samples, not empty, are of this proxy.
AmbiguityMap ambiguityOf(const TriangleMesh &proxy, const MeshTopology &topology,
                         const std::vector<LabelSample> &samples, const AmbiguityMapOptions &options);

/// One flag a vertex: within \a distance, walked along edges, of an edge whose ends have different labels.
std::vector<char> nearBorder(const TriangleMesh &proxy, const MeshTopology &topology,
                             const std::vector<int> &labels, double distance);

} // namespace ductus
