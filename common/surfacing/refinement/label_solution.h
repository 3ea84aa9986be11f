// LabelSolution: the regions of a proxy with everything a further scribble starts from.
#pragma once

#include "surfacing/refinement/scribble.h"
#include "surfacing/segmentation/multi_model_fit.h"

#include <memory>

namespace ductus {

struct LabelSolution
{
    Segmentation segmentation;        // what extraction needs; models only those used
    std::vector<int> modelIds;        // beside segmentation.models: names that survive scribbles
    std::vector<char> vertexIsLocked; // one a proxy vertex

    ModelLabeling fit;               // labels and models with their costs, the start of the next scribble
    LabelConstraints constraints;    // of all scribbles so far
    std::vector<Scribble> scribbles; // applied, in order
    std::shared_ptr<const LabelSolution> before; // without the last scribble, or, after strokes changed,
                                                 // without all; null for the automatic solution
};

} // namespace ductus
