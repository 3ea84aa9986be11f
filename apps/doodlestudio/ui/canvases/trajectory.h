// The way a canvas goes, in the picture of the present frame, with time as colour.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"

#include <QPainter>
#include <QPointF>
#include <optional>
#include <vector>

namespace ductus {

class PlayerView;

struct Trajectory
{
    std::vector<std::optional<QPointF>> points; // widget pixels, one a frame; none behind the camera

    /// The frame whose place is nearest to \a point, within \a reach; none if there is none.
    std::optional<int> frameNear(const QPointF &point, double reach) const;
};

/// Empty for canvases that stand still.
Trajectory trajectoryOf(const StudioState &state, const Canvas &canvas, const PlayerView &view);

void paintTrajectory(QPainter &painter, const Trajectory &trajectory, const Canvas &canvas, int presentFrame,
                     std::optional<int> hovered);

/// From blue at the begin to red at the end.
QColor timeColour(double share);

} // namespace ductus
