#include "doodling/tracking/orientation.h"

#include "doodling/tracking/motion_direction.h"

#include <ceres/ceres.h>
#include <cmath>

namespace ductus {

namespace {

using Quaternion = Eigen::Quaterniond;

// sqrt(w) (R r - v)
struct AlongMotion
{
    Vec3 direction;
    double scale;

    template <typename T>
    bool operator()(const T *rotation, const T *relative, T *residual) const
    {
        const Eigen::Map<const Eigen::Quaternion<T>> r(rotation);
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> axis(relative);
        Eigen::Map<Eigen::Matrix<T, 3, 1>> out(residual);
        out = T(scale) * (r * axis - direction.cast<T>());
        return true;
    }
};

// Of length scale |R_1 - R_0|_F = scale sqrt(8) |sin(half the angle)|, which is the vector part's length.
struct FewTurns
{
    double scale;

    template <typename T>
    bool operator()(const T *rotation0, const T *rotation1, T *residual) const
    {
        const Eigen::Map<const Eigen::Quaternion<T>> r0(rotation0), r1(rotation1);
        Eigen::Map<Eigen::Matrix<T, 3, 1>> out(residual);
        out = T(scale * std::sqrt(8.0)) * (r0.conjugate() * r1).vec();
        return true;
    }
};

class CancelCallback : public ceres::IterationCallback
{
public:
    explicit CancelCallback(const JobControl &control) : mControl(control) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary &) override
    {
        return mControl.isCancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

private:
    const JobControl &mControl;
};

Error unusable(const std::string &problem)
{
    return {ErrorCode::InvalidArgument, "Turning the canvas", problem,
            "Remove the orientation keyframe and set it again", ""};
}

Result<void> checkInput(const std::vector<Vec3> &trajectory,
                        const std::vector<OrientationKeyframe> &keyframes)
{
    if (keyframes.empty())
        return unusable("there is no orientation keyframe");
    for (const Vec3 &p : trajectory)
        if (!p.allFinite())
            return unusable("the trajectory is not a number");
    int last = -1;
    for (const OrientationKeyframe &key : keyframes) {
        if (key.frame <= last || key.frame >= int(trajectory.size()))
            return unusable("keyframe at frame " + std::to_string(key.frame) +
                            " is out of order or beyond the clip");
        if (!(std::abs(key.worldFromCanvas.norm() - 1.0) < 1e-6))
            return unusable("keyframe at frame " + std::to_string(key.frame) + " is no rotation");
        last = key.frame;
    }
    return {};
}

// From one frame to a neighbour as if fixed to the direction of motion.
Quaternion carried(const Quaternion &rotation, const MotionDirection &motion, std::size_t from,
                   std::size_t to)
{
    if (motion.segments[from] < 0 || motion.segments[from] != motion.segments[to])
        return rotation;
    return (Quaternion::FromTwoVectors(motion.directions[from], motion.directions[to]) * rotation)
        .normalized();
}

std::vector<Quaternion> startOf(const MotionDirection &motion,
                                const std::vector<OrientationKeyframe> &keyframes)
{
    const std::size_t frames = motion.segments.size();
    std::vector<Quaternion> rotations(frames);
    for (const OrientationKeyframe &key : keyframes)
        rotations[std::size_t(key.frame)] = key.worldFromCanvas.normalized();
    for (std::size_t t = std::size_t(keyframes.front().frame); t-- > 0;)
        rotations[t] = carried(rotations[t + 1], motion, t + 1, t);
    for (std::size_t t = std::size_t(keyframes.back().frame); t + 1 < frames; ++t)
        rotations[t + 1] = carried(rotations[t], motion, t, t + 1);
    for (std::size_t k = 0; k + 1 < keyframes.size(); ++k) {
        const std::size_t from = std::size_t(keyframes[k].frame), to = std::size_t(keyframes[k + 1].frame);
        std::vector<Quaternion> ahead{rotations[from]};
        for (std::size_t t = from; t + 1 < to; ++t)
            ahead.push_back(carried(ahead.back(), motion, t, t + 1));
        for (std::size_t t = to; t-- > from + 1;) {
            const Quaternion back = carried(rotations[t + 1], motion, t + 1, t);
            rotations[t] = back; // blended below, when its neighbours were carried
        }
        for (std::size_t t = from + 1; t < to; ++t)
            rotations[t] = ahead[t - from].slerp(double(t - from) / double(to - from), rotations[t]);
    }
    return rotations;
}

// The best r_s for given rotations: the mean of the motion as the canvas sees it.
std::vector<Vec3> relativeDirections(const MotionDirection &motion, const std::vector<Quaternion> &rotations)
{
    std::vector<Vec3> relative(std::size_t(motion.segmentCount), Vec3::Zero());
    for (std::size_t t = 0; t < rotations.size(); ++t)
        if (motion.segments[t] >= 0)
            relative[std::size_t(motion.segments[t])] +=
                motion.weights[t] * (rotations[t].conjugate() * motion.directions[t]);
    for (Vec3 &r : relative)
        r = r.norm() > 1e-9 ? Vec3(r.normalized()) : Vec3(Vec3::UnitX());
    return relative;
}

} // namespace

Result<std::vector<Quaternion>> solveOrientations(const std::vector<Vec3> &trajectory,
                                                  const std::vector<OrientationKeyframe> &keyframes,
                                                  const OrientationOptions &options,
                                                  const JobControl &control)
{
    if (Result<void> checked = checkInput(trajectory, keyframes); !checked)
        return checked.error();
    const MotionDirection motion = motionDirections(trajectory, options);
    std::vector<Quaternion> rotations = startOf(motion, keyframes);
    std::vector<Vec3> relative = relativeDirections(motion, rotations);

    ceres::Problem problem;
    for (Quaternion &rotation : rotations)
        problem.AddParameterBlock(rotation.coeffs().data(), 4, new ceres::EigenQuaternionManifold);
    for (Vec3 &direction : relative)
        problem.AddParameterBlock(direction.data(), 3, new ceres::SphereManifold<3>);
    for (std::size_t t = 0; t + 1 < rotations.size(); ++t)
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<FewTurns, 3, 4, 4>(new FewTurns{std::sqrt(options.smoothness)}),
            nullptr, rotations[t].coeffs().data(), rotations[t + 1].coeffs().data());
    for (std::size_t t = 0; t < rotations.size(); ++t)
        if (motion.segments[t] >= 0)
            problem.AddResidualBlock(new ceres::AutoDiffCostFunction<AlongMotion, 3, 4, 3>(
                                         new AlongMotion{motion.directions[t], std::sqrt(motion.weights[t])}),
                                     nullptr, rotations[t].coeffs().data(),
                                     relative[std::size_t(motion.segments[t])].data());
    for (const OrientationKeyframe &key : keyframes)
        problem.SetParameterBlockConstant(rotations[std::size_t(key.frame)].coeffs().data());

    CancelCallback onIteration(control);
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    solver.max_num_iterations = 60;
    solver.function_tolerance = 1e-9;
    solver.logging_type = ceres::SILENT;
    solver.callbacks.push_back(&onIteration);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    if (control.isCancelled())
        return cancelledError("Turning the canvas");
    if (!summary.IsSolutionUsable())
        return Error{ErrorCode::NoSolution, "Turning the canvas", summary.message,
                     "Set an orientation keyframe where the canvas turns wrongly", ""};
    for (Quaternion &rotation : rotations)
        rotation.normalize();
    return rotations;
}

} // namespace ductus
