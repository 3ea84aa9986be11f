// What a surfaced sketch leaves open: the ambiguity map and the alternatives of a state, and taking one of
// them.
#pragma once

#include "surfacing/ambiguity/alternatives.h"
#include "surfacing/ambiguity/ambiguity_map.h"
#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

struct AmbiguityOptions
{
    LabelSampleOptions samples;
    AmbiguityMapOptions map;
    AlternativeOptions alternatives;
};

struct Ambiguity
{
    AmbiguityMap map;          // on the proxy (of the solved half)
    std::vector<double> shown; // AmbiguityMap::either, one a vertex of SurfacingState::proxyInInput
    std::vector<Segmentation> alternatives; // most different first
};

/// Of a \a state with labels, with its own options; takes as long as labelling with as many runs. The strokes
/// are judged, not the scribbles: what a scribble settled stays marked.
Result<Ambiguity> findAmbiguity(const SurfacingState &state, const AmbiguityOptions &options,
                                const JobControl &control);

/// \a state labelled as \a alternative has it, without scribbles, to be extracted; further scribbles start
/// from there.
Result<SurfacingState> withAlternative(const SurfacingState &state, const Segmentation &alternative,
                                       const JobControl &control);

} // namespace ductus
