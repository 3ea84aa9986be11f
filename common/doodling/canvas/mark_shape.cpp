#include "doodling/canvas/mark_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

double distanceToSegment(const Vec2 &point, const Vec2 &a, const Vec2 &b)
{
    const Vec2 along = b - a;
    const double squared = along.squaredNorm();
    const double share = squared > 0.0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (point - a - share * along).norm();
}

double distanceToBox(const Vec2 &point, const Vec2 &middle, const Vec2 &size, double turn)
{
    const Vec2 inBox = Eigen::Rotation2Dd(-turn) * (point - middle);
    return (inBox.cwiseAbs() - 0.5 * size).cwiseMax(0.0).norm();
}

bool isInside(const Vec2 &point, const std::vector<Vec2> &outline)
{
    int winding = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if ((a.y() <= point.y()) == (b.y() <= point.y()))
            continue;
        const double x = a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y());
        if (x > point.x())
            winding += b.y() > a.y() ? 1 : -1;
    }
    return winding != 0;
}

Vec2 textSize(const TextMark &text)
{
    constexpr double letter = 0.55; // of the height; what a plain sans serif has on average
    std::size_t longest = 0, current = 0, lines = 1;
    for (const char byte : text.text) {
        if (byte == '\n') {
            current = 0;
            ++lines;
        } else if ((byte & 0xc0) != 0x80) { // the first byte of a character
            longest = std::max(longest, ++current);
        }
    }
    return text.height * Vec2(letter * double(longest), double(lines));
}

struct Distance
{
    Vec2 point;

    double operator()(const InkStroke &ink) const
    {
        return std::max(0.0, distanceToLine(point, flatPoints(ink.line)) - 0.5 * ink.width);
    }
    double operator()(const FilledShape &shape) const
    {
        if (shape.outline.empty() || isInside(point, shape.outline))
            return shape.outline.empty() ? 1e300 : 0.0;
        std::vector<Vec2> closed = shape.outline;
        closed.push_back(closed.front());
        return distanceToLine(point, closed);
    }
    double operator()(const TextMark &text) const
    {
        return distanceToBox(point, text.place, textSize(text), text.turn);
    }
    double operator()(const ArrowMark &arrow) const
    {
        return std::max(0.0, distanceToLine(point, arrow.points) - 0.5 * arrow.width);
    }
    double operator()(const StickerMark &sticker) const
    {
        return distanceToBox(point, sticker.place, Vec2::Constant(sticker.size), sticker.turn);
    }
    double operator()(const PictureMark &picture) const
    {
        return distanceToBox(point, picture.place, picture.size, picture.turn);
    }
};

} // namespace

double distanceToLine(const Vec2 &point, const std::vector<Vec2> &line)
{
    double least = 1e300;
    if (line.size() == 1)
        return (point - line.front()).norm();
    for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, distanceToSegment(point, line[i - 1], line[i]));
    return least;
}

double distanceToMark(const Vec2 &point, const DoodleMark &mark)
{
    return std::visit(Distance{point}, mark);
}

std::vector<Vec2> flatPoints(const Stroke &line)
{
    std::vector<Vec2> points;
    for (const Vec3 &point : line.points)
        points.push_back(point.head<2>());
    return points;
}

} // namespace ductus
