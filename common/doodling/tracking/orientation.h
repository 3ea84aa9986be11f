// Orientations along a trajectory (thesis VI.5.2, Eq. VI.3): the canvas keeps its direction relative to where
// it goes, turns no more than needed, and has the keyframed orientations exactly:
//
//     min_{R^t, r_s}  sum_t w_t |R^t r_{s(t)} - v^t|^2  +  lambda sum_t |R^{t+1} - R^t|_F^2        R^k = R~^k
//
// v^t is the unit direction of motion. The thesis' R*_s enters by its first axis r_s only (a unit vector:
// turning about it changes nothing), so two unknowns a segment are left of three. Segments s end where the
// motion all but stops. Gauss-Newton on the product of rotations and spheres [Ceres], started by carrying the
// keyframes along the trajectory: milliseconds for every frame, where the thesis solves for each fifth one in
// seconds.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <vector>

namespace ductus {

struct OrientationKeyframe
{
    int frame = 0;
    Eigen::Quaterniond worldFromCanvas = Eigen::Quaterniond::Identity();
};

struct OrientationOptions
{
    double smoothness = 10.0; // lambda_smooth, thesis VI.5.2
    double turnSpeed = 0.2;   // share of the greatest speed below which a new segment begins, thesis VI.5.2
    int shortestSegment = 3;  // frames; shorter ones carry no direction (published program)
    double fastQuantile =
        0.9; // speeds from this quantile on have weight 1, slower ones less (published program)
    int smoothingFrames = 3; // the direction of motion is that from so many frames before to so many after
    double stillSpeed =
        1e-4; // scene units a frame; a trajectory that is slower has no direction (published program)
};

/// One orientation a frame of \a trajectory. \a keyframes by frame, each frame once, at least one (the
/// canvas' first orientation counts as one). InvalidArgument for others.
Result<std::vector<Eigen::Quaterniond>> solveOrientations(const std::vector<Vec3> &trajectory,
                                                          const std::vector<OrientationKeyframe> &keyframes,
                                                          const OrientationOptions &options = {},
                                                          const JobControl &control = {});

} // namespace ductus
