#include "sketchsurfacer/ui/tools/painted_line.h"

#include "sketchsurfacer/ui/viewport/sketch_view.h"

namespace ductus {

void paintLine(QPainter &painter, const SketchView &view, const std::vector<Vec3> &points,
               const QColor &colour, double width)
{
    QPolygonF line;
    for (const Vec3 &p : points)
        if (const std::optional<QPointF> at = view.camera().project(p))
            line << *at;
    if (line.isEmpty())
        return;
    if (line.size() == 1)
        line << line.first() + QPointF(0.1, 0);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 110), width + 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

} // namespace ductus
