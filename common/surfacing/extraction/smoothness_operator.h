// The quadratic smoothness terms of E_mesh (Eq. III.11) as one scalar matrix, equal for x, y and z.
#pragma once

#include "surfacing/extraction/mesh_optimization.h"

#include <Eigen/SparseCore>

namespace ductus {

/// w_v of Eq. III.11 for every vertex: 1 inside regions, 0 on junctions of more than two regions and on creases,
/// linear in the angle between the models' gradients in between.
std::vector<double> smoothnessWeights(const SeamedMesh &seamed, const std::vector<Vec3> &positions,
                                      const std::vector<ImplicitPolynomial> &models,
                                      const MeshOptimizationOptions &options);

/// gamma_2D L^T W L + gamma_1D L_1^T L_1. Border vertices use their border neighbours, vertices flagged in
/// \a inPlane both halves' neighbours.
Eigen::SparseMatrix<double> smoothnessMatrix(const SeamedMesh &seamed, const MeshTopology &topology,
                                             const std::vector<double> &weights, const std::vector<char> &inPlane,
                                             const MeshOptimizationOptions &options);

} // namespace ductus
