#include "doodlestudio/ui/canvases/canvas_layer.h"

#include "doodlestudio/ui/canvases/mark_painter.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodling/canvas/doodle_time.h"

#include <algorithm>

namespace ductus {

void CanvasLayer::paint(QPainter &painter, const PlayerView &view)
{
    if (mAreDrawingsVisible)
        paintDrawings(painter, view);
    if (!mAreEdgesVisible)
        return;
    for (const Canvas &canvas : mState.document().scene().canvases)
        if (isShownIn(canvas, mState.frame()))
            paintEdge(painter, view, canvas);
}

void CanvasLayer::paintDrawings(QPainter &painter, const PlayerView &view) const
{
    struct Layer
    {
        const Canvas *canvas;
        QTransform transform;
        double depth;
    };
    std::vector<Layer> layers;
    for (const Canvas &canvas : mState.document().scene().canvases) {
        if (!isShownIn(canvas, mState.frame()))
            continue;
        if (const std::optional<QTransform> transform = mState.workingFromCanvas(canvas))
            layers.push_back({&canvas, *transform, mState.place(canvas)->depth});
    }
    std::stable_sort(layers.begin(), layers.end(),
                     [](const Layer &a, const Layer &b) { return a.depth > b.depth; });
    for (const Layer &layer : layers) {
        const std::optional<int> drawing = doodleFrameAt(layer.canvas->doodle, mState.frame());
        if (!drawing)
            continue;
        painter.save();
        painter.setClipRect(view.pictureRect(), Qt::IntersectClip);
        painter.setOpacity(layer.canvas->opacity);
        painter.setTransform(layer.transform * view.viewFromWorking() * painter.transform());
        paintMarks(painter, layer.canvas->doodle.frames[std::size_t(*drawing)]);
        painter.restore();
    }
}

void CanvasLayer::paintEdge(QPainter &painter, const PlayerView &view, const Canvas &canvas) const
{
    const std::optional<CanvasView> seen = mState.view(canvas);
    if (!seen)
        return;
    QPolygonF edge;
    for (const Vec2 &corner : {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)}) {
        const std::optional<Vec2> pixel = seen->pixelOf(corner.cwiseProduct(canvas.size));
        if (!pixel)
            return;
        edge << view.toView(toPoint(*pixel));
    }
    const bool isChosen = canvas.id == mState.chosen();
    const QColor colour = canvasColour(canvas.id);
    painter.setBrush(Qt::NoBrush);
    // A dark line below: to be seen on bright and dark pictures alike.
    painter.setPen(QPen(QColor(0, 0, 0, 120), isChosen ? 4.0 : 3.0));
    painter.drawPolygon(edge);
    painter.setPen(QPen(colour, isChosen ? 2.0 : 1.2, isChosen ? Qt::SolidLine : Qt::DashLine));
    painter.drawPolygon(edge);
    const QString name = QString::fromStdString(canvas.name);
    const QFontMetricsF metrics(painter.font());
    QPointF at = edge.boundingRect().topLeft() + QPointF(0, -6);
    const QRectF ground(at.x(), at.y() - metrics.height(), metrics.horizontalAdvance(name) + 12,
                        metrics.height() + 2);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isChosen ? colour : QColor(0, 0, 0, 140));
    painter.drawRoundedRect(ground, 3, 3);
    painter.setPen(isChosen ? QColor(0x1d, 0x21, 0x26) : QColor(0xff, 0xff, 0xff));
    painter.drawText(ground, Qt::AlignCenter, name);
}

} // namespace ductus
