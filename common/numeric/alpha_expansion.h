// Multi-label energy minimisation by alpha-expansion with label costs [Boykov, Veksler, Zabih 2001; Delong,
// Osokin, Isack, Boykov 2012], on Kolmogorov's max-flow (libmaxflow).
//
//     E(l) = sum_v D_v(l_v) + sum_{uv} w_uv [l_u != l_v] + sum_{a used} h_a
//
// Data costs and weights must be finite and >= 0; label costs >= 0. Construction of one expansion:
// surfacing-research.md section 5 (one auxiliary node per used label that carries a cost).
#pragma once

#include "base/job_control.h"
#include "base/result.h"

#include <span>
#include <vector>

namespace ductus {

struct LabelingEdge
{
    int u = 0;
    int v = 0;
    double weight = 0.0;
};

struct LabelingProblem
{
    int vertexCount = 0;
    std::vector<std::span<const double>>
        dataCosts;                   // one column a label, vertexCount long: dataCosts[a][v] = D_v(a)
    std::vector<LabelingEdge> edges; // each pair at most once, no loops
    std::vector<double> labelCosts;  // h_a, one a label

    int labelCount() const { return int(dataCosts.size()); }
};

struct AlphaExpansionOptions
{
    int maxCycles = 50;               // a cycle tries every label once; ends earlier when nothing changes
    double relativeTolerance = 1e-12; // a move must lower the energy by more than this share
};

struct Labeling
{
    std::vector<int> labels; // one a vertex
    double energy = 0.0;
    int cycles = 0;
};

/// The energy of \a labels, by definition.
double labelingEnergy(const LabelingProblem &problem, const std::vector<int> &labels);

/// A local minimum no single expansion can improve. Starts from \a initial, or where that is empty from the
/// single best label. Deterministic. Fails with Cancelled, or InvalidArgument for a malformed problem.
Result<Labeling> alphaExpansion(const LabelingProblem &problem, const AlphaExpansionOptions &options,
                                const std::vector<int> &initial, const JobControl &control);

} // namespace ductus
