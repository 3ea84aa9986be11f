#include "render/upload/ribbon_vertex.h"

#include "painting/blend/blend.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

std::array<std::int16_t, 4> fractions(const Eigen::Vector3f &v, float w)
{
    const auto one = [](float x) { return std::int16_t(std::lround(32767 * std::clamp(x, -1.f, 1.f))); };
    return {one(v[0]), one(v[1]), one(v[2]), one(w)};
}

/// Points spread evenly along the stroke, its ends among them; the width of each is the mean around it, so
/// that tapered ends do not make the whole stroke thin.
std::vector<PaintedPoint> fewPoints(const StrokeShape &stroke, std::size_t most)
{
    std::vector<float> lengths{0};
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        lengths.push_back(lengths.back() +
                          (stroke.points[i].position - stroke.points[i - 1].position).norm());
    const std::size_t count = std::min(most, stroke.points.size());
    std::vector<PaintedPoint> points;
    for (std::size_t k = 0; k < count; ++k) {
        const float step = lengths.back() / float(count - 1), at = step * float(k);
        const auto next = std::lower_bound(lengths.begin(), lengths.end(), at);
        PaintedPoint point =
            stroke
                .points[std::min<std::size_t>(std::size_t(next - lengths.begin()), stroke.points.size() - 1)];
        float width = 0, weight = 0;
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const float share = std::max(0.f, 1 - std::abs(lengths[i] - at) / std::max(step, 1e-30f));
            width += share * stroke.points[i].halfWidth;
            weight += share;
        }
        point.halfWidth = weight > 0 ? width / weight : point.halfWidth;
        points.push_back(point);
    }
    return points;
}

} // namespace

void appendRibbon(const StrokeShape &stroke, std::uint32_t element, std::size_t most,
                  std::vector<RibbonVertex> &vertices)
{
    if (stroke.points.size() < 2)
        return;
    const std::vector<PaintedPoint> points = fewPoints(stroke, std::max<std::size_t>(most, 2));
    const std::size_t begin = vertices.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PaintedPoint &point = points[i];
        const Eigen::Vector3f way =
            points[std::min(i + 1, points.size() - 1)].position - points[i > 0 ? i - 1 : 0].position;
        if (!(way.norm() > 0))
            continue;
        const Eigen::Vector3f along = way.normalized();
        // Half of a round end sticks out; ribbons and boxes end flat.
        const bool isRound =
            stroke.section == StrokeSection::Round || stroke.section == StrokeSection::Ellipse;
        const float out = !isRound ? 0 : i == 0 ? -0.6f : i + 1 == points.size() ? 0.6f : 0;
        const Eigen::Vector3f at = point.position + out * point.halfWidth * along;
        const Vec3 encoded = toBlendSpace(BlendSpace::Encoded, point.colour.cast<double>());
        const auto byte = [](double x) { return std::uint8_t(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
        RibbonVertex vertex{
            {at[0], at[1], at[2]},
            point.halfWidth,
            fractions(along, float(int(stroke.section)) / 32767.f),
            fractions(point.normal.normalized(), 0),
            {byte(encoded[0]), byte(encoded[1]), byte(encoded[2]), byte(double(point.opacity))},
            element};
        const bool isFirst = vertices.size() == begin;
        vertices.insert(vertices.end(), isFirst ? 2 : 1, vertex);
        vertex.halfWidth = -vertex.halfWidth;
        vertices.push_back(vertex);
    }
    if (vertices.size() > begin)
        vertices.push_back(vertices.back());
}

} // namespace ductus
