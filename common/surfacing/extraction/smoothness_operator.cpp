#include "surfacing/extraction/smoothness_operator.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

Eigen::SparseMatrix<double> matrixOf(int size, const Triplets &triplets)
{
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

} // namespace

std::vector<double> smoothnessWeights(const SeamedMesh &seamed, const std::vector<Vec3> &positions,
                                      const std::vector<ImplicitPolynomial> &models,
                                      const MeshOptimizationOptions &options)
{
    std::vector<double> weights(positions.size(), 1.0);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const std::vector<int> &labels = seamed.vertexLabels[v];
        if (labels.size() > 2)
            weights[v] = 0.0;
        if (labels.size() != 2)
            continue;
        Vec3 n0, n1;
        models[std::size_t(labels[0])].signedDistance(positions[v], &n0);
        models[std::size_t(labels[1])].signedDistance(positions[v], &n1);
        const double angle = std::acos(std::clamp(n0.dot(n1), -1.0, 1.0));
        weights[v] = std::clamp((options.sharpAngle - angle) / (options.sharpAngle - options.smoothAngle), 0.0, 1.0);
    }
    return weights;
}

Eigen::SparseMatrix<double> smoothnessMatrix(const SeamedMesh &seamed, const MeshTopology &topology,
                                             const std::vector<double> &weights, const std::vector<char> &inPlane,
                                             const MeshOptimizationOptions &options)
{
    const int n = seamed.mesh.vertexCount();
    const std::vector<char> border = topology.borderVertices();
    Triplets surface, weightDiagonal, seam;
    for (int v = 0; v < n; ++v) {
        const bool mirrored = !inPlane.empty() && inPlane[std::size_t(v)];
        const bool isBorder = border[std::size_t(v)] && !mirrored;
        double total = 0.0;
        for (int e : topology.vertexEdges[std::size_t(v)]) {
            if (isBorder && !topology.isBorder(e))
                continue;
            total += mirrored && !topology.isBorder(e) ? 2.0 : 1.0;
        }
        if (total == 0.0)
            continue;
        surface.emplace_back(v, v, 1.0);
        for (int e : topology.vertexEdges[std::size_t(v)]) {
            if (isBorder && !topology.isBorder(e))
                continue;
            surface.emplace_back(v, topology.neighbour(v, e),
                                 -(mirrored && !topology.isBorder(e) ? 2.0 : 1.0) / total);
        }
        weightDiagonal.emplace_back(v, v, options.surfaceSmoothness * weights[std::size_t(v)]);
    }
    std::vector<std::vector<int>> seamNeighbours(seamed.mesh.vertices.size());
    for (const auto &[a, b] : seamed.seamEdges) {
        seamNeighbours[std::size_t(a)].push_back(b);
        seamNeighbours[std::size_t(b)].push_back(a);
    }
    for (int v = 0; v < n; ++v) {
        const std::vector<int> &neighbours = seamNeighbours[std::size_t(v)];
        if (neighbours.size() != 2) // ends and junctions of seams are left to their surfaces
            continue;
        seam.emplace_back(v, v, 1.0);
        for (int u : neighbours)
            seam.emplace_back(v, u, -0.5);
    }
    const Eigen::SparseMatrix<double> L = matrixOf(n, surface), W = matrixOf(n, weightDiagonal), L1 = matrixOf(n, seam);
    Eigen::SparseMatrix<double> result = L.transpose() * W * L;
    result += options.seamSmoothness * Eigen::SparseMatrix<double>(L1.transpose() * L1);
    return result;
}

} // namespace ductus
