#include "doodling/reconstruction/cameras/first_pair.h"

#include "doodling/reconstruction/cameras/camera_fit.h"

#include <opencv2/calib3d.hpp>

#include <algorithm>

namespace ductus {

namespace {

constexpr int parts = 6; // of the clip, one start in each
constexpr int gaps[] = {2, 4, 7, 11, 16, 24, 36, 50};
constexpr std::size_t fewestCommon = 40;
constexpr double leastParallax = 1.0;         // pixels at 854 of width
constexpr double enoughParallaxShare = 0.012; // of the width: more is no better
constexpr double leastInlierShare = 0.4;

struct Common
{
    std::vector<Vec2> first, second;
};

Common commonOf(const std::vector<PointTrack> &tracks, int first, int second)
{
    Common common;
    for (const PointTrack &track : tracks)
        if (track.isIn(first) && track.isIn(second)) {
            common.first.push_back(track.at(first));
            common.second.push_back(track.at(second));
        }
    return common;
}

// What is left of the motion when the camera may only turn.
double parallaxOf(const Common &common, const ShotCamera &lens)
{
    std::vector<PointSighting> sightings;
    for (std::size_t i = 0; i < common.first.size(); ++i) {
        const Vec3 ray = lens.rayOf(common.first[i]);
        sightings.push_back({HomogeneousPoint(ray.x(), ray.y(), ray.z(), 0.0), common.second[i]});
    }
    ShotCamera turned = lens;
    return fitCamera(turned, sightings, true, 4.0).spread;
}

std::vector<cv::Point2d> toCv(const std::vector<Vec2> &pixels)
{
    std::vector<cv::Point2d> points;
    for (const Vec2 &pixel : pixels)
        points.emplace_back(pixel.x(), pixel.y());
    return points;
}

std::optional<FirstPair> pairOf(const Common &common, const ShotCamera &lens, double parallax)
{
    const std::vector<cv::Point2d> first = toCv(common.first), second = toCv(common.second);
    const cv::Point2d centre(lens.centre.x(), lens.centre.y());
    cv::Mat inliers;
    const cv::Mat essential =
        cv::findEssentialMat(first, second, lens.focal, centre, cv::RANSAC, 0.999, 1.0, inliers);
    if (essential.rows != 3 || essential.cols != 3)
        return std::nullopt;
    cv::Mat rotation, translation;
    const int good =
        cv::recoverPose(essential, first, second, rotation, translation, lens.focal, centre, inliers);
    if (good < leastInlierShare * double(first.size()))
        return std::nullopt;
    Eigen::Matrix3d r;
    Vec3 t;
    for (int row = 0; row < 3; ++row) {
        t[row] = translation.at<double>(row);
        for (int column = 0; column < 3; ++column)
            r(row, column) = rotation.at<double>(row, column);
    }
    if (!r.allFinite() || !t.allFinite())
        return std::nullopt;
    FirstPair pair;
    pair.firstCamera = pair.secondCamera = lens;
    pair.secondCamera.worldFromCamera.linear() = r.transpose();
    pair.secondCamera.worldFromCamera.translation() = -r.transpose() * t;
    pair.parallax = parallax;
    const double enough = enoughParallaxShare * 2.0 * lens.centre.x();
    pair.score = good * std::min(1.0, parallax / enough) * good / double(first.size());
    return pair;
}

} // namespace

std::vector<FirstPair> firstPairs(const std::vector<PointTrack> &tracks, int frameCount,
                                  const ShotCamera &lens, const JobControl &control)
{
    std::vector<FirstPair> best;
    const double least = leastParallax * 2.0 * lens.centre.x() / 854.0;
    for (int part = 0; part < parts && !control.isCancelled(); ++part) {
        const int first = part * frameCount / parts;
        std::optional<FirstPair> bestHere;
        for (int gap : gaps) {
            const int second = first + gap;
            if (second >= frameCount)
                break;
            const Common common = commonOf(tracks, first, second);
            if (common.first.size() < fewestCommon)
                break;
            const double parallax = parallaxOf(common, lens);
            if (parallax < least)
                continue;
            std::optional<FirstPair> pair = pairOf(common, lens, parallax);
            if (pair && (!bestHere || pair->score > bestHere->score)) {
                pair->first = first;
                pair->second = second;
                bestHere = std::move(pair);
            }
        }
        if (bestHere)
            best.push_back(*bestHere);
    }
    std::stable_sort(best.begin(), best.end(),
                     [](const FirstPair &a, const FirstPair &b) { return a.score > b.score; });
    return best;
}

} // namespace ductus
