#include "sketchsurfacer/ui/viewport/view_mark.h"

#include "sketchsurfacer/ui/viewport/view_camera.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double roomAround = 0.35; // tangent of the angle: 20 degrees

} // namespace

Vec3 freeDirection(const ViewMark &mark, const RayTree &tree, const Vec3 &present, double beside)
{
    // With some room around: what is seen along the surface is hardly seen.
    const auto isFreeFrom = [&](const Vec3 &place, const Vec3 &direction, double from) {
        const Vec3 aside = roomAround * direction.unitOrthogonal(), across = direction.cross(aside);
        for (const Vec3 &tilted : {direction, Vec3(direction + aside), Vec3(direction - aside),
                                   Vec3(direction + across), Vec3(direction - across)})
            if (tree.isBlocked(place, tilted.normalized(), from, 1e300))
                return false;
        return true;
    };
    const auto isFree = [&](const Vec3 &direction) {
        return isFreeFrom(mark.at, direction, beside) ||
               (mark.other && isFreeFrom(mark.centre(), direction, 0.0));
    };
    if (tree.isEmpty() || isFree(present))
        return present;
    constexpr int tried = 200;
    constexpr double goldenAngle = 2.399963229728653;
    Vec3 best = present;
    double nearest = -2.0;
    for (int i = 0; i < tried; ++i) {
        // Evenly over the sphere (Fibonacci lattice).
        const double y = 1.0 - (2.0 * i + 1.0) / tried, r = std::sqrt(1.0 - y * y);
        const Vec3 direction(r * std::cos(goldenAngle * i), y, r * std::sin(goldenAngle * i));
        if (const double cosine = direction.dot(present); cosine > nearest && isFree(direction)) {
            nearest = cosine;
            best = direction;
        }
    }
    return best;
}

void paintMark(QPainter &painter, const ViewCamera &camera, const ViewMark &mark)
{
    const std::optional<QPointF> at = camera.project(mark.at);
    if (!at)
        return;
    const QPointF other = mark.other ? camera.project(*mark.other).value_or(*at) : *at;
    const QPointF centre = 0.5 * (*at + other);
    const double apart = std::hypot(other.x() - at->x(), other.y() - at->y());
    const double radius = std::max(16.0, 0.5 * apart + 10.0);
    for (const bool isEdge : {true, false}) { // dark around bright: seen on every ground
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(isEdge ? QColor(0, 0, 0, 140) : QColor(255, 196, 64), isEdge ? 5.0 : 2.5));
        painter.drawEllipse(centre, radius, radius);
        if (apart > 2.0)
            painter.drawLine(*at, other);
    }
    QRectF box = painter.fontMetrics().boundingRect(mark.text).adjusted(-9, -5, 9, 5);
    box.moveCenter(centre + QPointF(0, -radius - 20));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 22, 26, 225));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(QColor(240, 242, 245));
    painter.drawText(box, Qt::AlignCenter, mark.text);
}

} // namespace ductus
