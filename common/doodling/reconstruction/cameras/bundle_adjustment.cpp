#include "doodling/reconstruction/cameras/bundle_adjustment.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <array>
#include <cmath>

namespace ductus {

namespace {

// Angle-axis of cameraFromWorld, then the position.
using CameraNumbers = std::array<double, 6>;

struct SightingMiss
{
    Vec2 pixel, centre;

    template <typename T>
    bool operator()(const T *camera, const T *point, const T *logFocal, T *miss) const
    {
        const T offset[3] = {point[0] - point[3] * camera[3], point[1] - point[3] * camera[4],
                             point[2] - point[3] * camera[5]};
        T y[3];
        ceres::AngleAxisRotatePoint(camera, offset, y);
        // Behind the camera: a distance that leads nowhere, but is finite.
        const T depth = y[2] > T(1e-6) ? y[2] : T(1e-6);
        const T focal = exp(logFocal[0]);
        miss[0] = focal * y[0] / depth + T(centre.x() - pixel.x());
        miss[1] = focal * y[1] / depth + T(centre.y() - pixel.y());
        return true;
    }
};

struct FocalOpinion
{
    double logFocal, weight;

    template <typename T>
    bool operator()(const T *focal, T *miss) const
    {
        miss[0] = T(weight) * (focal[0] - T(logFocal));
        return true;
    }
};

struct SpeedChange
{
    double weight;

    template <typename T>
    bool operator()(const T *before, const T *camera, const T *after, T *miss) const
    {
        for (int i = 0; i < 3; ++i)
            miss[i] = T(weight) * (before[3 + i] - 2.0 * camera[3 + i] + after[3 + i]);
        return true;
    }
};

class CancelCheck : public ceres::IterationCallback
{
public:
    explicit CancelCheck(const JobControl &control) : mControl(control) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary &) override
    {
        return mControl.isCancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

private:
    const JobControl &mControl;
};

CameraNumbers numbersOf(const ShotCamera &camera)
{
    CameraNumbers numbers;
    const Eigen::Matrix3d cameraFromWorld = camera.worldFromCamera.linear().transpose();
    ceres::RotationMatrixToAngleAxis(cameraFromWorld.data(), numbers.data());
    Eigen::Map<Vec3>(numbers.data() + 3) = camera.position();
    return numbers;
}

void setNumbers(ShotCamera &camera, const CameraNumbers &numbers, double focal)
{
    Eigen::Matrix3d cameraFromWorld;
    ceres::AngleAxisToRotationMatrix(numbers.data(), cameraFromWorld.data());
    camera.worldFromCamera.linear() = cameraFromWorld.transpose();
    camera.worldFromCamera.translation() = Eigen::Map<const Vec3>(numbers.data() + 3);
    camera.focal = focal;
}

// The first camera holds the world in its place; the scale is held by nothing but the solver's damping.
void holdCameras(ceres::Problem &problem, std::vector<CameraNumbers> &cameras, bool isRotationOnly)
{
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        double *numbers = cameras[i].data();
        if (!problem.HasParameterBlock(numbers))
            continue;
        if (i == 0)
            problem.SetParameterBlockConstant(numbers);
        else if (isRotationOnly)
            problem.SetManifold(numbers, new ceres::SubsetManifold(6, {3, 4, 5}));
    }
}

void addSmoothness(ceres::Problem &problem, std::vector<CameraNumbers> &cameras, const BundleOptions &options,
                   double focal)
{
    if (options.isRotationOnly || !(options.usualDepth > 0.0))
        return;
    const double weight = std::sqrt(options.smoothTrust) * focal / options.usualDepth;
    for (std::size_t i = 1; i + 1 < cameras.size(); ++i)
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<SpeedChange, 3, 6, 6, 6>(new SpeedChange{weight}),
            new ceres::HuberLoss(1.0), cameras[i - 1].data(), cameras[i].data(), cameras[i + 1].data());
}

} // namespace

bool adjustBundle(Bundle &bundle, const BundleOptions &options, const JobControl &control)
{
    if (bundle.sightings.empty() || bundle.cameras.empty())
        return false;
    std::vector<CameraNumbers> cameras;
    for (const ShotCamera &camera : bundle.cameras)
        cameras.push_back(numbersOf(camera));
    std::vector<HomogeneousPoint> points = bundle.points;
    for (HomogeneousPoint &point : points)
        point.normalize();
    double logFocal = std::log(bundle.cameras.front().focal);
    ceres::Problem problem;
    auto *ordering = new ceres::ParameterBlockOrdering;
    for (const BundleSighting &sighting : bundle.sightings) {
        double *point = points[std::size_t(sighting.point)].data();
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<SightingMiss, 2, 6, 4, 1>(new SightingMiss{
                                     sighting.pixel, bundle.cameras[std::size_t(sighting.camera)].centre}),
                                 new ceres::HuberLoss(options.huberPixels),
                                 cameras[std::size_t(sighting.camera)].data(), point, &logFocal);
        if (!problem.HasManifold(point))
            problem.SetManifold(point, new ceres::SphereManifold<4>);
        ordering->AddElementToGroup(point, 0);
    }
    ordering->AddElementToGroup(&logFocal, 1);
    addSmoothness(problem, cameras, options, bundle.cameras.front().focal);
    for (CameraNumbers &camera : cameras)
        if (problem.HasParameterBlock(camera.data()))
            ordering->AddElementToGroup(camera.data(), 1);
    holdCameras(problem, cameras, options.isRotationOnly);
    if (!options.solvesFocal)
        problem.SetParameterBlockConstant(&logFocal);
    else if (options.likelyFocal > 0.0)
        problem.AddResidualBlock(
            new ceres::AutoDiffCostFunction<FocalOpinion, 1, 1>(new FocalOpinion{
                std::log(options.likelyFocal), std::sqrt(options.focalTrust) / options.focalSpread}),
            nullptr, &logFocal);
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    solver.min_lm_diagonal = 1e-4; // the scale is free, and so are points that never come nearer
    solver.linear_solver_ordering.reset(ordering);
    solver.max_num_iterations = options.iterations;
    solver.initial_trust_region_radius = 100.0; // small first steps: two cameras alone hold hardly anything
    solver.num_threads = 1;                     // sums in one order
    solver.function_tolerance = 1e-4;
    solver.logging_type = ceres::SILENT;
    CancelCheck cancelCheck(control);
    solver.callbacks.push_back(&cancelCheck);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    if (!summary.IsSolutionUsable())
        return false;
    const double focal = std::exp(logFocal);
    for (std::size_t i = 0; i < cameras.size(); ++i)
        setNumbers(bundle.cameras[i], cameras[i], focal);
    for (std::size_t i = 0; i < points.size(); ++i)
        bundle.points[i] = points[i].w() < 0.0 ? HomogeneousPoint(-points[i]) : points[i];
    return true;
}

} // namespace ductus
