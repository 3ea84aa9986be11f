#include "render/upload/coarse_stroke.h"

#include <algorithm>
#include <vector>

namespace ductus {

namespace {

/// How far \a point is from the straight change between two others; \a error is the length colours count as.
double deviation(const PaintedPoint &a, const PaintedPoint &b, const PaintedPoint &point, double error)
{
    const Eigen::Vector3f along = b.position - a.position;
    const float length2 = along.squaredNorm();
    const float t =
        length2 > 0 ? std::clamp((point.position - a.position).dot(along) / length2, 0.f, 1.f) : 0.f;
    const auto between = [&](const auto &x, const auto &y) { return ((1 - t) * x + t * y).eval(); };
    const double place = double((point.position - between(a.position, b.position)).norm());
    const double width = std::abs(double(point.halfWidth - ((1 - t) * a.halfWidth + t * b.halfWidth)));
    const double colour = std::max(double((point.colour - between(a.colour, b.colour)).cwiseAbs().maxCoeff()),
                                   std::abs(double(point.opacity - ((1 - t) * a.opacity + t * b.opacity))));
    constexpr double colourStep = 0.04; // of linear light; what is seen of a stroke a pixel wide
    // Of sections that are not round the turn counts, too: by what it moves their edge.
    const double turn = double((point.normal - between(a.normal, b.normal)).norm() * point.halfWidth);
    return std::max({place + width, colour / colourStep * error, turn});
}

} // namespace

CoarseStroke coarseStroke(const StrokeShape &stroke)
{
    CoarseStroke coarse;
    coarse.shape.section = stroke.section;
    float widest = 0;
    for (const PaintedPoint &point : stroke.points)
        widest = std::max(widest, point.halfWidth);
    coarse.error = 0.5 * double(widest);

    const std::size_t count = stroke.points.size();
    std::vector<bool> stays(count, false);
    if (count > 0)
        stays.front() = stays.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open;
    if (count > 2)
        open.emplace_back(0, count - 1);
    while (!open.empty()) {
        const auto [begin, end] = open.back();
        open.pop_back();
        double most = coarse.error;
        std::size_t at = 0;
        for (std::size_t i = begin + 1; i < end; ++i) {
            const double d =
                deviation(stroke.points[begin], stroke.points[end], stroke.points[i], coarse.error);
            if (d > most) {
                most = d;
                at = i;
            }
        }
        if (at == 0)
            continue;
        stays[at] = true;
        open.emplace_back(begin, at);
        open.emplace_back(at, end);
    }
    for (std::size_t i = 0; i < count; ++i)
        if (stays[i])
            coarse.shape.points.push_back(stroke.points[i]);
    return coarse;
}

} // namespace ductus
