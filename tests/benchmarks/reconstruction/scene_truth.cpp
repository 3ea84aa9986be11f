#include "benchmarks/reconstruction/scene_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::string rungName(CameraKnowledge knowledge)
{
    return knowledge == CameraKnowledge::SolvedCameras  ? "solved"
           : knowledge == CameraKnowledge::RotationOnly ? "rotation"
                                                        : "tripod";
}

std::optional<double> pathErrorShare(const std::vector<ShotCamera> &found,
                                     const std::vector<ShotCamera> &real)
{
    const Eigen::Index count = Eigen::Index(std::min(found.size(), real.size()));
    Eigen::Matrix3Xd from(3, count), to(3, count);
    double length = 0.0;
    for (Eigen::Index t = 0; t < count; ++t) {
        from.col(t) = found[std::size_t(t)].position();
        to.col(t) = real[std::size_t(t)].position();
        if (t > 0)
            length += (to.col(t) - to.col(t - 1)).norm();
    }
    if (count < 3 || length < 1e-9)
        return std::nullopt;
    const Eigen::Matrix4d similarity = Eigen::umeyama(from, to, true);
    const Eigen::Matrix3Xd moved =
        (similarity.topLeftCorner<3, 3>() * from).colwise() + Vec3(similarity.topRightCorner<3, 1>());
    return std::sqrt((moved - to).squaredNorm() / double(count)) / length;
}

double worstTurnDegrees(const std::vector<ShotCamera> &found, const std::vector<ShotCamera> &real)
{
    double worst = 0.0;
    for (std::size_t t = 0; t < std::min(found.size(), real.size()); ++t) {
        const Eigen::Matrix3d a =
            found[0].worldFromCamera.linear().transpose() * found[t].worldFromCamera.linear();
        const Eigen::Matrix3d b =
            real[0].worldFromCamera.linear().transpose() * real[t].worldFromCamera.linear();
        worst = std::max(worst, Eigen::AngleAxisd(Eigen::Matrix3d(a.transpose() * b)).angle());
    }
    return worst * 180.0 / std::numbers::pi;
}

std::optional<double> medianDepthError(const std::vector<DepthPair> &pairs)
{
    if (pairs.empty())
        return std::nullopt;
    std::vector<double> ratios, errors;
    for (const DepthPair &pair : pairs)
        ratios.push_back(pair.found / pair.real);
    const double scale = medianOf(ratios);
    for (double ratio : ratios)
        errors.push_back(std::abs(ratio / scale - 1.0));
    return medianOf(std::move(errors));
}

} // namespace ductus
