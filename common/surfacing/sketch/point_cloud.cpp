#include "surfacing/sketch/point_cloud.h"

#include "geometry/point_tree.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace ductus {

namespace {

constexpr const char *attempted = "Surfacing the points";
constexpr int fewestPoints = 100; // the variational fit makes a shape of fewer, but rarely the one meant
// Third by second principal spread of a point and its 15 nearest: 0.75 for points all over a box; 500 points
// of a hand have 0.42, of a bust 0.19, 1000 of a sphere with noise of 6 % of its radius 0.47.
constexpr double mostThickness = 0.62;
constexpr int neighbours = 16;

double thicknessAt(const PointTree &tree, const Vec3 &point)
{
    const std::vector<int> near = tree.nearest(point, neighbours);
    Vec3 mean = Vec3::Zero();
    for (int i : near)
        mean += tree.points()[std::size_t(i)] / double(near.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (int i : near) {
        const Vec3 d = tree.points()[std::size_t(i)] - mean;
        spread += d * d.transpose();
    }
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
    return moments[1] > 0.0 ? std::sqrt(std::max(0.0, moments[0]) / moments[1]) : 0.0;
}

} // namespace

bool isPointCloud(const StrokeSet &strokes)
{
    const auto isPoint = [](const Stroke &stroke) { return stroke.points.size() == 1; };
    const auto points = std::count_if(strokes.strokes.begin(), strokes.strokes.end(), isPoint);
    return points >= 16 && std::size_t(points) * 10 >= strokes.strokes.size() * 9;
}

StrokeSet cleanedCloud(const StrokeSet &cloud)
{
    const auto lessByPlace = [&](std::size_t a, std::size_t b) {
        const Vec3 &p = cloud.strokes[a].points.front(), &q = cloud.strokes[b].points.front();
        return std::make_tuple(p.x(), p.y(), p.z(), a) < std::make_tuple(q.x(), q.y(), q.z(), b);
    };
    std::vector<std::size_t> order;
    for (std::size_t s = 0; s < cloud.strokes.size(); ++s)
        if (!cloud.strokes[s].points.empty())
            order.push_back(s);
    std::sort(order.begin(), order.end(), lessByPlace);
    std::vector<char> isKept(cloud.strokes.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i)
        isKept[order[i]] =
            i == 0 || cloud.strokes[order[i]].points.front() != cloud.strokes[order[i - 1]].points.front();
    StrokeSet result = cloud;
    result.strokes.clear();
    for (std::size_t s = 0; s < cloud.strokes.size(); ++s)
        if (isKept[s])
            result.strokes.push_back(cloud.strokes[s]);
    return result;
}

Result<void> checkCloudIsSurface(const StrokeSet &cloud)
{
    const std::vector<Vec3> points = cloud.allPoints();
    if (int(points.size()) < fewestPoints)
        return Error{
            ErrorCode::TooLittleData, attempted,
            "these are only " + std::to_string(points.size()) + " points that do not follow one another",
            "Give at least " + std::to_string(fewestPoints) +
                " points of the surface, or the points of each stroke in drawing order with a blank line "
                "between strokes",
            ""};
    const PointTree tree(points);
    std::vector<double> thickness;
    const std::size_t stride = points.size() / 500 + 1;
    for (std::size_t i = 0; i < points.size(); i += stride)
        thickness.push_back(thicknessAt(tree, points[i]));
    std::nth_element(thickness.begin(), thickness.begin() + std::ptrdiff_t(thickness.size() / 2),
                     thickness.end());
    if (thickness[thickness.size() / 2] > mostThickness)
        return Error{
            ErrorCode::NoSolution, attempted,
            "these " + std::to_string(points.size()) +
                " points are a cloud of points that fills a volume: they lie on no surface",
            "Give more points of the surface, or the points of each stroke in drawing order with a blank "
            "line between strokes",
            ""};
    return {};
}

} // namespace ductus
