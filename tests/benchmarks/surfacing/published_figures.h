// What others reported, to print beside our numbers. Their machines are not ours: compare orders, not digits.
#pragma once

#include <string>
#include <vector>

namespace ductus {

/// A row of the thesis' Table III.1, wall seconds; whether the ten restarts are in them is not said.
struct ThesisTiming
{
    std::string sketch;
    double initialisation = 0.0; // (1): association and step 0 of Algorithm 1
    double segmentation = 0.0;   // (2): the rest of Algorithm 1
    double extraction = 0.0;     // (3)
    int iterations = 0;
};

const std::vector<ThesisTiming> &thesisTimings();

/// Null if there is no such row.
const ThesisTiming *thesisTiming(const std::string &sketch);

/// The program of Huang, Carr and Ju 2019 (lambda 0, 100 voxels), fit and contour together: user seconds and
/// highest memory. Measured once with their program on a machine of 2 cores, not by this benchmark.
struct VipssCost
{
    std::string input;
    int points = 0;
    double cpuSeconds = 0.0;
    double megabytes = 0.0;
};

const std::vector<VipssCost> &vipssCosts();

/// Its distances in % of the diagonal of the input's box.
struct VipssDistances
{
    std::string input;
    double inputMean = 0.0, inputP95 = 0.0, inputMax = 0.0; // input points to result
    double truthMean = 0.0, truthP95 = 0.0, truthMax = 0.0; // truth to result
};

/// Null if it was not measured.
const VipssDistances *vipssDistances(const std::string &input);

} // namespace ductus
