// A line in space painted flat above the scene: shown at once, whatever a frame costs.
#pragma once

#include "geometry/triangle_mesh.h"

#include <QColor>
#include <QPainter>
#include <vector>

namespace ductus {

class SketchView;

void paintLine(QPainter &painter, const SketchView &view, const std::vector<Vec3> &points,
               const QColor &colour, double width);

} // namespace ductus
