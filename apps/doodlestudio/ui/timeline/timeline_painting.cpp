// How the timeline looks.
#include "doodlestudio/ui/timeline/timeline_view.h"

#include "doodlestudio/ui/timeline/timeline_metrics.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

// A distance between labels of the ruler that people count in, at least \a least seconds.
double labelStep(double least)
{
    for (double step : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 300.0})
        if (step >= least)
            return step;
    return 600.0;
}

} // namespace

void TimelineView::paintEvent(QPaintEvent *)
{
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = coloursOf(palette());
    painter.fillRect(viewport()->rect(), colours.panel);
    if (mTimes.empty())
        return;
    painter.save();
    painter.setClipRect(0, rulerHeight, viewport()->width(), viewport()->height() - rulerHeight);
    for (int row = 0; row < mRows.size(); ++row)
        paintRow(painter, row);
    if (mSound)
        paintSound(painter, rowTop(int(mRows.size())));
    if (mRows.isEmpty()) {
        painter.setPen(colours.dim);
        painter.drawText(QRectF(headerWidth, rulerHeight + (mSound ? soundHeight : 0),
                                viewport()->width() - headerWidth, rowHeight),
                         Qt::AlignVCenter | Qt::AlignLeft, tr("Canvases will stand here, one a row."));
    }
    painter.restore();
    paintRuler(painter);
    const double x = xOf(mFrame + 0.5);
    if (x >= headerWidth) {
        painter.setPen(QPen(colours.accent, 1.5));
        painter.drawLine(QPointF(x, 4), QPointF(x, viewport()->height()));
        QPainterPath head;
        head.moveTo(x - 6, 2);
        head.lineTo(x + 6, 2);
        head.lineTo(x, 12);
        head.closeSubpath();
        painter.fillPath(head, colours.accent);
    }
}

void TimelineView::paintRuler(QPainter &painter)
{
    const ThemeColours colours = coloursOf(palette());
    painter.fillRect(QRect(0, 0, viewport()->width(), rulerHeight), colours.panel);
    painter.setPen(colours.line);
    painter.drawLine(QPointF(0, rulerHeight - 0.5), QPointF(viewport()->width(), rulerHeight - 0.5));
    painter.drawLine(QPointF(headerWidth - 0.5, 0), QPointF(headerWidth - 0.5, viewport()->height()));
    const double frameSeconds = mTimes.size() > 1 ? mTimes.back() / double(mTimes.size() - 1) : 0.04;
    const double step = labelStep(64.0 / columnWidth() * frameSeconds);
    painter.setFont(font());
    const double end = mTimes.back() + frameSeconds;
    for (int i = 0; i * step <= end; ++i) {
        const double seconds = i * step;
        const auto after = std::lower_bound(mTimes.begin(), mTimes.end(), seconds - 1e-6);
        const double x = xOf(double(after - mTimes.begin()));
        if (x < headerWidth)
            continue;
        painter.setPen(colours.line);
        painter.drawLine(QPointF(x, rulerHeight - 7), QPointF(x, rulerHeight - 1));
        painter.setPen(colours.dim);
        painter.drawText(QRectF(x + 3, 0, 60, rulerHeight - 2), Qt::AlignVCenter | Qt::AlignLeft,
                         step < 1.0 ? tr("%1 s").arg(seconds, 0, 'f', 1)
                                    : tr("%1 s").arg(seconds, 0, 'f', 0));
    }
    if (columnWidth() >= 5.0) {
        painter.setPen(colours.line);
        for (int f = frameAt(headerWidth); f < frameCount() && xOf(f) < viewport()->width(); ++f)
            painter.drawLine(QPointF(xOf(f), rulerHeight - 4), QPointF(xOf(f), rulerHeight - 1));
    }
}

void TimelineView::paintRow(QPainter &painter, int row)
{
    const ThemeColours colours = coloursOf(palette());
    const TimelineRow &shown = mRows[row];
    const double top = rowTop(row);
    const double width = viewport()->width();
    if (shown.isChosen)
        painter.fillRect(QRectF(0, top, width, rowHeight), mixed(colours.panel, colours.accent, 0.12));
    const QColor colour = shown.isVisible ? shown.colour : mixed(shown.colour, colours.panel, 0.6);

    painter.save();
    painter.setClipRect(QRectF(headerWidth, top, width - headerWidth, rowHeight), Qt::IntersectClip);
    // Frames in which it faces the camera squarely are the good ones to draw on.
    for (std::size_t f = 0; f < shown.facing.size(); ++f) {
        const bool isHidden = f < shown.hidden.size() && shown.hidden[f];
        QColor ground = mixed(colours.panel, colour, isHidden ? 0.05 : 0.08 + 0.34 * shown.facing[f]);
        painter.fillRect(QRectF(xOf(double(f)), top + 3, columnWidth() + 0.5, 27), ground);
    }
    if (shown.facing.empty()) {
        painter.setPen(colours.dim);
        painter.drawText(QRectF(headerWidth + 8, top, 260, 30), Qt::AlignVCenter,
                         shown.follows ? tr("being followed...") : tr("stands still in the scene"));
    }
    for (const TimelineDrawing &drawing : shown.drawings) {
        const QRectF place(xOf(drawing.first) + 0.5, top + 32,
                           (drawing.last - drawing.first + 1) * columnWidth() - 1, 8);
        QColor fill = mixed(colours.raised, colour, drawing.isRepeat ? 0.35 : 0.85);
        if (drawing.isEmpty)
            fill = colours.raised;
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        painter.drawRoundedRect(place, 2, 2);
    }
    paintMarks(painter, row);
    painter.restore();

    painter.fillRect(QRectF(8, top + 12, 10, 10), colour);
    painter.setPen(shown.isVisible ? colours.text : colours.disabled);
    QFont name = font();
    name.setBold(shown.isChosen);
    painter.setFont(name);
    painter.drawText(QRectF(26, top, headerWidth - 32, rowHeight - 10), Qt::AlignVCenter,
                     QFontMetrics(name).elidedText(shown.name, Qt::ElideRight, headerWidth - 32));
    painter.setFont(font());
    painter.setPen(colours.line);
    painter.drawLine(QPointF(0, top + rowHeight - 0.5), QPointF(width, top + rowHeight - 0.5));
}

void TimelineView::paintMarks(QPainter &painter, int row)
{
    const ThemeColours colours = coloursOf(palette());
    const TimelineRow &shown = mRows[row];
    QList<TimelineMark> marks = shown.marks;
    if (mDrag == Drag::Mark && mDragged.row == row)
        for (TimelineMark &mark : marks)
            if (mark == *mDragged.mark)
                mark.frame = mDragFrame;
    std::stable_sort(marks.begin(), marks.end(),
                     [](const TimelineMark &a, const TimelineMark &b) { return a.frame < b.frame; });
    // Lines between keyframes: dotted where the canvas goes straight.
    for (const TimelineMarkKind kind : {TimelineMarkKind::Position, TimelineMarkKind::Turn}) {
        const TimelineMark *before = nullptr;
        for (const TimelineMark &mark : marks) {
            if (mark.kind != kind)
                continue;
            if (before) {
                painter.setPen(
                    QPen(colours.text, 1.2, before->interpolatesNext ? Qt::DotLine : Qt::SolidLine));
                painter.drawLine(QPointF(xOf(before->frame + 0.5), markY(row, kind)),
                                 QPointF(xOf(mark.frame + 0.5), markY(row, kind)));
            }
            before = &mark;
        }
    }
    for (const TimelineMark &mark : marks) {
        const QPointF middle(xOf(mark.frame + 0.5), markY(row, mark.kind));
        const bool isChosen = mChosenMark && mChosenMark->first == shown.id && mChosenMark->second == mark;
        painter.setPen(QPen(colours.text, isChosen ? 2.0 : 1.2));
        painter.setBrush(isChosen ? colours.accent : shown.colour);
        switch (mark.kind) {
        case TimelineMarkKind::Position:
            painter.drawEllipse(middle, 5.0, 5.0);
            break;
        case TimelineMarkKind::Turn:
            painter.drawPolygon(QPolygonF{middle + QPointF(0, -6), middle + QPointF(6, 0),
                                          middle + QPointF(0, 6), middle + QPointF(-6, 0)});
            break;
        case TimelineMarkKind::Depth:
            painter.drawPolygon(
                QPolygonF{middle + QPointF(-4, -9), middle + QPointF(4, -9), middle + QPointF(0, -4)});
            break;
        case TimelineMarkKind::Size:
            painter.drawRect(QRectF(middle + QPointF(-3.5, 3), QSizeF(7, 5)));
            break;
        }
    }
}

void TimelineView::paintSound(QPainter &painter, int top)
{
    const ThemeColours colours = coloursOf(palette());
    painter.setPen(colours.dim);
    painter.drawText(QRectF(26, top, headerWidth - 30, soundHeight), Qt::AlignVCenter, tr("Sound"));
    painter.setPen(mixed(colours.panel, colours.text, 0.45));
    const double middle = top + soundHeight / 2.0;
    const double frameSeconds = mTimes.size() > 1 ? mTimes.back() / double(mTimes.size() - 1) : 0.04;
    const double secondsAPixel = frameSeconds / columnWidth();
    const double end = std::min<double>(viewport()->width(), xOf(frameCount()));
    for (double x = headerWidth; x < end; x += 1.0) {
        const double seconds = (x - xOf(0)) * secondsAPixel;
        const double half =
            std::max(0.5, mSound->peak(seconds, seconds + secondsAPixel) * (soundHeight / 2.0 - 3));
        painter.drawLine(QPointF(x + 0.5, middle - half), QPointF(x + 0.5, middle + half));
    }
}

} // namespace ductus
