// Minimises g^T H g over unit vectors g_1 .. g_n (3n numbers, all x then all y then all z): L-BFGS on the product
// of spheres, with the projected gradient, renormalisation as retraction and projection as transport.
#pragma once

#include "base/job_control.h"
#include "base/result.h"

#include <Eigen/Core>
#include <functional>

namespace ductus {

struct SphereDescentOptions
{
    int maxIterations = 120;
    double tolerance = 1e-6; // relative decrease over an iteration that ends the descent
    int memory = 12;         // pairs L-BFGS remembers
};

struct SphereMinimum
{
    Eigen::VectorXd g;
    double energy = 0.0;
    int evaluations = 0;
};

Result<SphereMinimum> minimiseOnSpheres(const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &applyH,
                                        const Eigen::VectorXd &start, const SphereDescentOptions &options,
                                        const JobControl &control);

} // namespace ductus
