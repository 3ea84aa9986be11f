// Plausible segmentations of one sketch: what the runs from several seeds find, what becomes of the best of
// them when epsilon or the price of a model is half or twice what it was, and what is found with simpler
// models only (thesis Sec. III.9: a sketch stands for a space of shapes; Figs. III.10-12 show how the runs
// and the parameters move the result).
#pragma once

#include "surfacing/segmentation/segmentation.h"

namespace ductus {

struct LabelSampleOptions
{
    int runs = 10;
    double parameterFactor = 2.0; // on epsilon and on simplicity, up and down
    int simplerRuns = 2;          // best of, for each highest degree below the one the best run needs
    double temperature = 0.1;     // who is worse by this share of the least energy counts 1/e
};

struct LabelSample
{
    Segmentation segmentation; // with the energies it has under the options as given
    double weight = 1.0;       // how plausible it is; 1 at most
};

/// The runs in the order of their numbers, the four changed parameters, then the lower degrees. \a options:
/// as the user has them; their number of runs does not matter.
Result<std::vector<LabelSample>> labelSamples(const Association &association, const MeshTopology &topology,
                                              const SegmentationOptions &options,
                                              const LabelSampleOptions &sampleOptions,
                                              const JobControl &control);

} // namespace ductus
