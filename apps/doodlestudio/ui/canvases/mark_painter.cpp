#include "doodlestudio/ui/canvases/mark_painter.h"

#include "doodlestudio/ui/canvases/studio_state.h"
#include "doodling/compositing/mark_pieces.h"
#include "doodling/compositing/text_outlines.h"

#include <QImage>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

QPointF grained(const Vec2 &v)
{
    return {v.x() * canvasGrain, v.y() * canvasGrain};
}

// A four-cornered piece between two circles, turning the way QPainterPath's ellipses do: with the other
// turn the two would cancel out where they overlap.
void addPiece(QPainterPath &path, const QPointF &a, double radiusA, const QPointF &b, double radiusB)
{
    const QPointF along = b - a;
    const double length = std::hypot(along.x(), along.y());
    if (length < 1e-9)
        return;
    const QPointF normal(-along.y() / length, along.x() / length);
    path.addPolygon(QPolygonF{a + normal * radiusA, a - normal * radiusA, b - normal * radiusB,
                              b + normal * radiusB, a + normal * radiusA});
}

void paint(QPainter &painter, const LinePiece &piece)
{
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const LinePiece::Line &line : piece.lines) {
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const QPointF here = grained(line.points[i]);
            const double radius = line.radii[i] * canvasGrain;
            path.addEllipse(here, radius, radius);
            if (i + 1 < line.points.size())
                addPiece(path, here, radius, grained(line.points[i + 1]), line.radii[i + 1] * canvasGrain);
        }
    }
    painter.fillPath(path, toColour(piece.colour));
}

void paint(QPainter &painter, const AreaPiece &piece)
{
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const Outline &outline : piece.outlines) {
        QPolygonF polygon;
        for (const Vec2 &point : outline)
            polygon << grained(point);
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    painter.fillPath(path, toColour(piece.colour));
}

void paint(QPainter &painter, const PicturePiece &piece)
{
    const Image &image = *piece.image;
    const QImage shown(image.pixels.data(), image.width, image.height, image.width * 4,
                       QImage::Format_RGBA8888);
    const Vec2 right = piece.right / image.width, down = piece.down / image.height;
    painter.save();
    painter.setTransform(QTransform(right.x() * canvasGrain, right.y() * canvasGrain, down.x() * canvasGrain,
                                    down.y() * canvasGrain, piece.corner.x() * canvasGrain,
                                    piece.corner.y() * canvasGrain),
                         true);
    painter.drawImage(QPointF(0, 0), shown);
    painter.restore();
}

} // namespace

QColor toColour(const Rgba &colour)
{
    return {colour[0], colour[1], colour[2], colour[3]};
}

Rgba toRgba(const QColor &colour)
{
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()),
            std::uint8_t(colour.alpha())};
}

void paintMark(QPainter &painter, const DoodleMark &mark)
{
    static const TextOutlines fonts; // read once: a cache of the computer's fonts
    for (const MarkPiece &piece : piecesOf(mark, fonts))
        std::visit([&](const auto &one) { paint(painter, one); }, piece);
}

void paintMarks(QPainter &painter, const DoodleFrame &frame)
{
    for (const MarkPointer &mark : frame.marks)
        paintMark(painter, *mark);
}

} // namespace ductus
