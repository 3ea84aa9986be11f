#include "surfacing/proxy/least_squares_mesh.h"

#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "numeric/sparse_cholesky.h"

#include <Eigen/SparseCore>

namespace ductus {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

Eigen::SparseMatrix<double> graphLaplacian(const TriangleMesh &mesh, const MeshTopology &topology)
{
    Triplets triplets;
    const std::vector<char> border = topology.borderVertices();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        // On a border only the border neighbours count, so that it is smoothed as a curve.
        std::vector<int> neighbours;
        for (int e : topology.vertexEdges[std::size_t(v)])
            if (!border[std::size_t(v)] || topology.isBorder(e))
                neighbours.push_back(topology.neighbour(v, e));
        if (neighbours.empty())
            continue;
        triplets.emplace_back(v, v, 1.0);
        for (int n : neighbours)
            triplets.emplace_back(v, n, -1.0 / double(neighbours.size()));
    }
    Eigen::SparseMatrix<double> L(mesh.vertexCount(), mesh.vertexCount());
    L.setFromTriplets(triplets.begin(), triplets.end());
    return L;
}

} // namespace

Result<TriangleMesh> attracted(const TriangleMesh &proxy, const std::vector<Vec3> &strokePoints,
                               const AttractionOptions &options, const JobControl &control)
{
    const MeshTopology topology(proxy);
    const Eigen::SparseMatrix<double> L = graphLaplacian(proxy, topology);
    const Eigen::SparseMatrix<double> smooth = Eigen::SparseMatrix<double>(L.transpose()) * L;
    const std::vector<char> border = topology.borderVertices();

    TriangleMesh result = proxy;
    for (int round = 0; round < options.rounds; ++round) {
        if (control.isCancelled())
            return cancelledError("Attracting the proxy to the strokes");
        control.progress(double(round) / options.rounds, "Attracting the proxy");
        const NearestOnMesh nearest(result);
        Triplets controls;
        std::vector<Vec3> targets;
        for (const Vec3 &p : strokePoints) {
            const NearestPoint foot = nearest.nearest(p);
            if (foot.distance > options.maxDistance)
                continue;
            for (int k = 0; k < 3; ++k)
                controls.emplace_back(int(targets.size()), proxy.triangles[std::size_t(foot.triangle)][std::size_t(k)],
                                      foot.barycentric[k]);
            targets.push_back(p);
        }
        Eigen::SparseMatrix<double> B(Eigen::Index(targets.size()), proxy.vertexCount());
        B.setFromTriplets(controls.begin(), controls.end());
        Eigen::SparseMatrix<double> system =
            smooth + options.controlWeight * Eigen::SparseMatrix<double>(B.transpose() * B);
        Eigen::MatrixXd P(Eigen::Index(targets.size()), 3), rightSide(proxy.vertexCount(), 3);
        for (std::size_t i = 0; i < targets.size(); ++i)
            P.row(Eigen::Index(i)) = targets[i].transpose();
        rightSide = options.controlWeight * (B.transpose() * P);
        for (int v = 0; v < proxy.vertexCount(); ++v) {
            const double w = border[std::size_t(v)] ? options.borderAnchorWeight : options.anchorWeight;
            system.coeffRef(v, v) += w;
            rightSide.row(v) += w * proxy.vertices[std::size_t(v)].transpose();
        }
        SparseCholesky factor;
        if (!factor.factorize(system))
            return Error{ErrorCode::NoSolution, "Attracting the proxy to the strokes", "the equations are singular",
                         "Repair the proxy mesh, or let one be made automatically", ""};
        const Eigen::MatrixXd x = factor.solve(rightSide);
        for (int v = 0; v < proxy.vertexCount(); ++v)
            result.vertices[std::size_t(v)] = x.row(v).transpose();
    }
    return result;
}

} // namespace ductus
