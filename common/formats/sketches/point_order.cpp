#include "formats/sketches/point_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

constexpr std::size_t windowSize = 512;
constexpr std::size_t mostWindows = 32;
constexpr double unorderedRatio = 3.0;
constexpr double unorderedStep = 0.1; // of the box diagonal

double median(std::vector<double> &values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

bool isUnordered(const std::vector<Vec3> &points)
{
    if (points.size() < 16)
        return false;
    // A window of a shuffled file is a thinner sample of the same shape, so nearest distances inside the
    // window grow but stay far below the consecutive ones; a window of a stroke is a piece of the stroke.
    const std::size_t size = std::min(windowSize, points.size());
    const std::size_t windows = std::min(mostWindows, points.size() / size);
    const std::size_t stride = windows > 1 ? (points.size() - size) / (windows - 1) : 0;
    std::vector<double> toNext;
    std::vector<double> toNearest;
    Box3 box;
    for (std::size_t w = 0; w < windows; ++w) {
        const std::size_t begin = w * stride;
        for (std::size_t i = begin; i < begin + size; ++i) {
            box.add(points[i]);
            // Points at the same place (pauses of the pen, retraced lines) say nothing about the order.
            if (i + 1 < begin + size && points[i + 1] != points[i])
                toNext.push_back((points[i + 1] - points[i]).norm());
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t j = begin; j < begin + size; ++j)
                if (points[j] != points[i])
                    nearest = std::min(nearest, (points[j] - points[i]).squaredNorm());
            if (std::isfinite(nearest))
                toNearest.push_back(std::sqrt(nearest));
        }
    }
    if (toNext.empty() || toNearest.empty())
        return false;
    const double step = median(toNext);
    return step > unorderedRatio * median(toNearest) && step > unorderedStep * box.diagonal();
}

} // namespace ductus
