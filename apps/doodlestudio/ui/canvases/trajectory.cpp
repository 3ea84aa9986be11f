#include "doodlestudio/ui/canvases/trajectory.h"

#include "doodlestudio/ui/player/player_view.h"

#include <algorithm>
#include <cmath>

namespace ductus {

QColor timeColour(double share)
{
    const double hue = 240.0 * (1.0 - std::clamp(share, 0.0, 1.0));
    return QColor::fromHsvF(float(hue / 360.0), 0.78f, 0.98f);
}

std::optional<int> Trajectory::frameNear(const QPointF &point, double reach) const
{
    std::optional<int> nearest;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i])
            continue;
        if (const double distance = QLineF(*points[i], point).length(); distance <= reach) {
            reach = distance;
            nearest = int(i);
        }
    }
    return nearest;
}

Trajectory trajectoryOf(const StudioState &state, const Canvas &canvas, const PlayerView &view)
{
    Trajectory trajectory;
    const std::shared_ptr<const Shot> shot = state.document().sceneShot();
    const std::shared_ptr<const CanvasTrack> track =
        const_cast<StudioState &>(state).follower().track(canvas.id);
    if (canvas.motion == CanvasMotion::Static || !track || state.frame() >= shot->frameCount())
        return trajectory;
    const ShotCamera &camera = shot->cameras[std::size_t(state.frame())];
    for (const CanvasFrame &frame : track->frames) {
        const std::optional<Vec2> pixel = camera.projected(frame.position);
        trajectory.points.push_back(pixel ? std::optional(view.toView(toPoint(*pixel))) : std::nullopt);
    }
    return trajectory;
}

void paintTrajectory(QPainter &painter, const Trajectory &trajectory, const Canvas &canvas, int presentFrame,
                     std::optional<int> hovered)
{
    const auto &points = trajectory.points;
    const auto share = [&](std::size_t i) {
        return points.size() > 1 ? double(i) / double(points.size() - 1) : 0.0;
    };
    for (const bool isGround : {true, false}) {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            if (!points[i] || !points[i + 1])
                continue;
            painter.setPen(isGround ? QPen(QColor(0, 0, 0, 110), 5.5, Qt::SolidLine, Qt::RoundCap)
                                    : QPen(timeColour(share(i)), 3.0, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(*points[i], *points[i + 1]);
        }
    }
    const auto dot = [&](int frame, double radius, const QColor &rim) {
        if (frame < 0 || frame >= int(points.size()) || !points[std::size_t(frame)])
            return;
        painter.setPen(QPen(rim, 1.8));
        painter.setBrush(timeColour(share(std::size_t(frame))));
        painter.drawEllipse(*points[std::size_t(frame)], radius, radius);
    };
    for (const CanvasKeyframe &key : canvas.keyframes.positions)
        dot(key.frame, 5.0, Qt::white);
    if (hovered && *hovered != presentFrame)
        dot(*hovered, 6.5, QColor(0, 0, 0));
}

} // namespace ductus
