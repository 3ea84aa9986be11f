#include "surfacing/extraction/mesh_optimization.h"

#include "base/parallel.h"
#include "numeric/sparse_cholesky.h"
#include "surfacing/extraction/smoothness_operator.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

using Positions = Eigen::MatrixXd; // V x 3

// The Gauss-Newton model of the projection term at the present positions: per vertex a symmetric 3x3 matrix
// and a gradient.
struct Projection
{
    std::vector<Eigen::Matrix3d> hessian;
    Positions gradient;
};

class Optimizer
{
public:
    Optimizer(const SeamedMesh &seamed, const std::vector<ImplicitPolynomial> &models,
              const std::vector<BorderAttraction> &borderTargets, const std::optional<SymmetryPlane> &plane,
              const std::vector<char> &inPlane, const MeshOptimizationOptions &options)
        : mSeamed(seamed), mModels(models), mBorderTargets(borderTargets), mPlane(plane), mInPlane(inPlane),
          mOptions(options), mTopology(seamed.mesh), mStartNormals(vertexNormals(seamed.mesh)),
          mX(seamed.mesh.vertexCount(), 3)
    {
        for (int v = 0; v < seamed.mesh.vertexCount(); ++v)
            mX.row(v) = seamed.mesh.vertices[std::size_t(v)].transpose();
    }

    Result<OptimizedMesh> run(const JobControl &control)
    {
        OptimizedMesh result;
        updateSmoothness();
        for (int round = 1; round <= mOptions.maxRounds; ++round) {
            if (control.isCancelled())
                return cancelledError("Fitting the final mesh");
            control.progress(double(round - 1) / mOptions.maxRounds, "Fitting the final mesh");
            if (round == 4) // seams have found their place: their angles are known now
                updateSmoothness();
            Positions step = solveRound();
            // No vertex jumps further than a model can be trusted.
            for (Eigen::Index v = 0; v < step.rows(); ++v) {
                const double length = step.row(v).norm();
                if (length > mOptions.trustDistance)
                    step.row(v) *= mOptions.trustDistance / length;
            }
            mX += step;
            result.rounds = round;
            if (step.rowwise().norm().maxCoeff() < mOptions.stillness && round > 4)
                break;
        }
        result.mesh = mSeamed.mesh;
        for (int v = 0; v < result.mesh.vertexCount(); ++v)
            result.mesh.vertices[std::size_t(v)] = mX.row(v).transpose();
        for (double w : mWeights)
            result.seamSharpness.push_back(1.0 - w);
        return result;
    }

private:
    void updateSmoothness()
    {
        std::vector<Vec3> positions(std::size_t(mX.rows()));
        for (Eigen::Index v = 0; v < mX.rows(); ++v)
            positions[std::size_t(v)] = mX.row(v).transpose();
        mWeights = smoothnessWeights(mSeamed, positions, mModels, mOptions);
        mSmooth = smoothnessMatrix(mSeamed, mTopology, mWeights, mInPlane, mOptions);
        Eigen::SparseMatrix<double> preconditioner = mSmooth;
        // The projection acts along one of three directions; the mean of its eigenvalues is a third.
        for (Eigen::Index v = 0; v < mX.rows(); ++v)
            preconditioner.coeffRef(v, v) += (1.0 + 2.0 * mOptions.sliding) / 3.0 + mOptions.damping;
        const bool ok = mPreconditioner.factorize(preconditioner);
        DUCTUS_ASSERT(ok); // a sum of squares plus a positive diagonal
    }

    Projection project() const
    {
        Projection p;
        p.hessian.assign(std::size_t(mX.rows()), Eigen::Matrix3d::Identity() * mOptions.damping);
        p.gradient.setZero(mX.rows(), 3);
        parallelFor(
            0, std::size_t(mX.rows()),
            [&](std::size_t v) {
                const Vec3 x = mX.row(Eigen::Index(v)).transpose();
                const std::vector<int> &labels = mSeamed.vertexLabels[v];
                const Eigen::Matrix3d along =
                    mOptions.sliding *
                    (Eigen::Matrix3d::Identity() - mStartNormals[v] * mStartNormals[v].transpose());
                p.hessian[v] += along;
                p.gradient.row(Eigen::Index(v)) += (along * (x - mSeamed.mesh.vertices[v])).transpose();
                for (int label : labels) {
                    Vec3 n;
                    const double distance = mModels[std::size_t(label)].signedDistance(x, &n);
                    const double ratio = distance / mOptions.trustDistance;
                    const double weight = 1.0 / (double(labels.size()) * (1.0 + ratio * ratio));
                    p.hessian[v] += weight * n * n.transpose();
                    p.gradient.row(Eigen::Index(v)) += weight * distance * n.transpose();
                }
            },
            256);
        for (const BorderAttraction &target : mBorderTargets) {
            p.hessian[std::size_t(target.vertex)] += Eigen::Matrix3d::Identity();
            p.gradient.row(target.vertex) += mX.row(target.vertex) - target.target.transpose();
        }
        return p;
    }

    // In-plane vertices may not leave the symmetry plane: their steps lose the normal part.
    void constrain(Positions &x) const
    {
        if (!mPlane || mInPlane.empty())
            return;
        for (Eigen::Index v = 0; v < x.rows(); ++v)
            if (mInPlane[std::size_t(v)])
                x.row(v) -= (x.row(v) * mPlane->normal) * mPlane->normal.transpose();
    }

    Positions apply(const Projection &p, const Positions &x) const
    {
        Positions y = mSmooth * x;
        for (Eigen::Index v = 0; v < x.rows(); ++v)
            y.row(v) += (p.hessian[std::size_t(v)] * x.row(v).transpose()).transpose();
        constrain(y);
        return y;
    }

    // (H + gamma L^T W L + damping) step = -gradient, by preconditioned conjugate gradients.
    Positions solveRound() const
    {
        const Projection p = project();
        Positions residual = -(p.gradient + mSmooth * mX);
        constrain(residual);
        Positions step = Positions::Zero(mX.rows(), 3);
        Positions z = mPreconditioner.solve(residual);
        constrain(z);
        Positions direction = z;
        double rz = residual.cwiseProduct(z).sum();
        const double enough = 1e-4 * rz;
        for (int iteration = 0; iteration < 40 && rz > enough && rz > 0.0; ++iteration) {
            const Positions y = apply(p, direction);
            const double alpha = rz / direction.cwiseProduct(y).sum();
            step += alpha * direction;
            residual -= alpha * y;
            z = mPreconditioner.solve(residual);
            constrain(z);
            const double next = residual.cwiseProduct(z).sum();
            direction = z + next / rz * direction;
            rz = next;
        }
        return step;
    }

    const SeamedMesh &mSeamed;
    const std::vector<ImplicitPolynomial> &mModels;
    const std::vector<BorderAttraction> &mBorderTargets;
    const std::optional<SymmetryPlane> &mPlane;
    const std::vector<char> &mInPlane;
    const MeshOptimizationOptions &mOptions;
    MeshTopology mTopology;
    std::vector<Vec3> mStartNormals;
    Positions mX;
    std::vector<double> mWeights;
    Eigen::SparseMatrix<double> mSmooth;
    SparseCholesky mPreconditioner;
};

} // namespace

Result<OptimizedMesh> optimizeMesh(const SeamedMesh &seamed, const std::vector<ImplicitPolynomial> &models,
                                   const std::vector<BorderAttraction> &borderTargets,
                                   const std::optional<SymmetryPlane> &plane,
                                   const std::vector<char> &inPlane, const MeshOptimizationOptions &options,
                                   const JobControl &control)
{
    return Optimizer(seamed, models, borderTargets, plane, inPlane, options).run(control);
}

} // namespace ductus
