// Multi-model fitting: which smooth surface model explains which part of the proxy (thesis Sec. III.5.2-3,
// Algorithm 1; PEARL [Isack, Boykov 2012] with label costs [Delong et al. 2012]).
//
//     E = E_fidelity (III.2) + w_smoothness E_smoothness (III.3) + w_simplicity E_simplicity (III.4)
//
// Several runs from differently seeded first models, in parallel; the lowest energy wins, ties go to the
// lower run number, so the answer depends on the seed and not on the machine.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "surfacing/association/association.h"

#include <cstdint>

namespace ductus {

/// What the proxy has to say where no stroke runs; used by dataCosts (data_costs.h says why).
struct ProxyPrior
{
    double distance = 0.05; // of model from proxy that costs nothing, share of the box diagonal
    double cosine = 0.5;    // nor does an angle of their normals up to 60 degrees
    double bound = 4.0;     // most a vertex can cost, before the weight
    double weight = 0.05;   // of the mean over vertices without strokes
};

struct SegmentationOptions
{
    double epsilon = 0.01;                             // share of the box diagonal, Sec. III.5.2
    double smoothness = 10.0;                          // w_smoothness, Sec. III.5.2
    double simplicity = 0.01;                          // w_simplicity, Sec. III.5.2
    double parameterNormaliser = 35.0;                 // D of Eq. III.4
    int maxDegree = 4;                                 // Sec. III.5.3
    std::vector<int> clusterCounts = {20, 30, 40, 50}; // Sec. III.5.3, Initialization
    double initialBoost = 10.0;                        // on mu and lambda of the first fits, Sec. III.5.3
    std::vector<int> initialDegrees = {1, 2, 4};       // of the first fits; the thesis: only 4
    int mergesPerIteration = 10;                       // the thesis: 3, Sec. III.5.3, New model proposal
    int maxIterations = 20;                            // the thesis needed 2 to 8
    int runs = 10;                                     // best of, Sec. III.7.1
    std::uint64_t seed = 1;
    bool simplifyGraph = true; // away from strokes, Sec. III.6: faster, and hardly another result
    ModelFitOptions fit;
    ProxyPrior proxyPrior; // beyond the thesis
};

struct Segmentation
{
    std::vector<int> labels;                // index into models, one a proxy vertex
    std::vector<ImplicitPolynomial> models; // only those used
    double energy = 0.0;
    double fidelity = 0.0;           // Eq. III.2
    double smoothness = 0.0;         // Eq. III.3, without its weight
    double simplicity = 0.0;         // Eq. III.4, without its weight
    int iterations = 0;              // of Algorithm 1
    std::vector<double> runEnergies; // of every run, to judge the spread (Fig. III.10)
};

Result<Segmentation> segment(const Association &association, const MeshTopology &topology,
                             const SegmentationOptions &options, const JobControl &control);

/// Every run instead of the best one, in the order of their numbers: to see where they disagree.
Result<std::vector<Segmentation>> segmentationRuns(const Association &association,
                                                   const MeshTopology &topology,
                                                   const SegmentationOptions &options,
                                                   const JobControl &control);

} // namespace ductus
