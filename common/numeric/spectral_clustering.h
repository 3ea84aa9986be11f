// Spectral clustering of a weighted graph [Shi, Malik 2000]: k-means on the lowest eigenvectors of the
// normalised Laplacian. One eigensolve serves all cluster counts (thesis Sec. III.5.3 asks for 20, 30, 40 and
// 50).
#pragma once

#include "base/job_control.h"
#include "base/random.h"
#include "base/result.h"
#include "numeric/alpha_expansion.h" // LabelingEdge

#include <Eigen/Core>
#include <vector>

namespace ductus {

/// The \a count eigenvectors of the normalised Laplacian with the smallest eigenvalues, one row a vertex,
/// ascending. Affinities (the edges' weights) must be finite and >= 0; loops count for nothing. The graph may
/// have several components, a vertex without edges being one: each gives an eigenvalue 0, the largest
/// component's vector first. Fewer columns when there are fewer vertices than \a count. Deterministic (fixed
/// start vectors, each column's entry of largest magnitude positive). Fails with Cancelled, InvalidArgument
/// or NoSolution.
Result<Eigen::MatrixXd> spectralEmbedding(int vertexCount, const std::vector<LabelingEdge> &edges, int count,
                                          const JobControl &control);

/// k-means++ and Lloyd on the first \a clusterCount columns of \a embedding, rows normalised to unit length
/// [Ng, Jordan, Weiss 2002]. Cluster number of each vertex, 0 .. clusterCount-1; empty clusters may occur.
std::vector<int> spectralClusters(const Eigen::MatrixXd &embedding, int clusterCount, Random random);

} // namespace ductus
