#include "doodling/reconstruction/cameras/camera_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ductus {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int cameraSteps = 12;
constexpr int depthSteps = 6;
constexpr double firstScale = 16.0; // pixels: from a wide funnel to a narrow one

Eigen::Matrix3d crossMatrix(const Vec3 &v)
{
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

Vec3 inCamera(const ShotCamera &camera, const HomogeneousPoint &point)
{
    return camera.worldFromCamera.linear().transpose() * (point.head<3>() - point.w() * camera.position());
}

double cauchy(double squared, double scale)
{
    return 1.0 / (1.0 + squared / (scale * scale));
}

void addNormalEquations(const ShotCamera &camera, const PointSighting &sighting, double scale,
                        Matrix6 &normal, Vector6 &right)
{
    const Vec3 y = inCamera(camera, sighting.point);
    const double most = 1e-9 * sighting.point.norm();
    if (y.z() <= most)
        return;
    const Vec2 miss = camera.centre + camera.focal * y.head<2>() / y.z() - sighting.pixel;
    Eigen::Matrix<double, 2, 3> projection;
    projection << 1, 0, -y.x() / y.z(), 0, 1, -y.y() / y.z();
    projection *= camera.focal / y.z();
    Eigen::Matrix<double, 2, 6> jacobian;
    jacobian.leftCols<3>() = projection * crossMatrix(y);
    jacobian.rightCols<3>() = -sighting.point.w() * projection;
    const double weight = cauchy(miss.squaredNorm(), scale);
    normal += weight * jacobian.transpose() * jacobian;
    right -= weight * jacobian.transpose() * miss;
}

CameraFit rated(const ShotCamera &camera, std::span<const PointSighting> sightings)
{
    std::vector<double> misses;
    for (const PointSighting &sighting : sightings) {
        const std::optional<Vec2> seen = projected(camera, sighting.point);
        misses.push_back(seen ? (*seen - sighting.pixel).norm() : 1e6);
    }
    if (misses.empty())
        return {};
    std::vector<double> sorted = misses;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
    CameraFit fit;
    fit.spread = sorted[sorted.size() / 2];
    for (double miss : misses)
        fit.inliers += miss < std::max(3.0, 3.0 * fit.spread);
    return fit;
}

} // namespace

std::optional<Vec2> projected(const ShotCamera &camera, const HomogeneousPoint &point)
{
    const Vec3 y = inCamera(camera, point);
    if (y.z() <= 1e-9 * point.norm())
        return std::nullopt;
    return Vec2(camera.centre + camera.focal * y.head<2>() / y.z());
}

CameraFit fitCamera(ShotCamera &camera, std::span<const PointSighting> sightings, bool isRotationOnly,
                    double scalePixels)
{
    double scale = std::max(scalePixels, firstScale);
    for (int step = 0; step < cameraSteps; ++step) {
        Matrix6 normal = Matrix6::Zero();
        Vector6 right = Vector6::Zero();
        for (const PointSighting &sighting : sightings)
            addNormalEquations(camera, sighting, scale, normal, right);
        if (isRotationOnly) {
            normal.rightCols<3>().setZero();
            normal.bottomRows<3>().setZero();
            normal.bottomRightCorner<3, 3>().setIdentity();
            right.tail<3>().setZero();
        }
        normal.diagonal() *= 1.0 + 1e-6;
        normal.diagonal().array() += 1e-12;
        const Vector6 change = normal.ldlt().solve(right);
        if (!change.allFinite())
            break;
        const Vec3 turn = change.head<3>();
        const Vec3 shift = camera.worldFromCamera.linear() * change.tail<3>();
        camera.worldFromCamera.translation() += shift;
        if (turn.norm() > 1e-15)
            camera.worldFromCamera.linear() =
                camera.worldFromCamera.linear() *
                Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
        scale = std::max(scalePixels, 0.6 * scale);
    }
    camera.worldFromCamera.linear() =
        Eigen::Quaterniond(camera.worldFromCamera.linear()).normalized().toRotationMatrix();
    return rated(camera, sightings);
}

InverseDepthFit fitInverseDepth(const ShotCamera &camera, const Vec2 &pixel,
                                std::span<const RaySighting> sightings, double start, double scalePixels)
{
    InverseDepthFit fit;
    fit.inverseDepth = start;
    const Vec3 ray = camera.rayOf(pixel);
    double scale = 4.0 * scalePixels;
    for (int step = 0; step < depthSteps; ++step) {
        double information = 0.0, right = 0.0, misses = 0.0, weights = 0.0;
        for (const RaySighting &sighting : sightings) {
            const ShotCamera &other = *sighting.camera;
            const Eigen::Matrix3d cameraFromWorld = other.worldFromCamera.linear().transpose();
            const Vec3 b = cameraFromWorld * (camera.position() - other.position());
            const Vec3 y = cameraFromWorld * ray + fit.inverseDepth * b;
            if (y.z() <= 1e-3)
                continue;
            const Vec2 miss = other.centre + other.focal * y.head<2>() / y.z() - sighting.pixel;
            const Vec2 slope = other.focal / (y.z() * y.z()) * (b.head<2>() * y.z() - b.z() * y.head<2>());
            const double squared = miss.squaredNorm();
            const double weight = sighting.weight * cauchy(squared, scale);
            information += weight * slope.squaredNorm();
            right -= weight * slope.dot(miss);
            misses += sighting.weight * std::min(std::sqrt(squared), 20.0);
            weights += sighting.weight;
        }
        fit.information = information;
        fit.miss = weights > 0.0 ? misses / weights : 0.0;
        if (!(information > 1e-12))
            break;
        fit.inverseDepth += right / information;
        scale = std::max(scalePixels, 0.6 * scale);
    }
    return fit;
}

} // namespace ductus
