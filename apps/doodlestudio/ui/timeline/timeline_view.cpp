#include "doodlestudio/ui/timeline/timeline_view.h"

#include "doodlestudio/ui/timeline/timeline_metrics.h"
#include "widgets/theme/theme.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int rightMargin = 12;
constexpr double markReach = 7.0; // pixels around a mark that hit it
constexpr int snapFrames = 1;

} // namespace

TimelineView::TimelineView(QWidget *parent) : QAbstractScrollArea(parent)
{
    setObjectName(QStringLiteral("timeline"));
    setAccessibleName(tr("Timeline"));
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
}

void TimelineView::setFrameTimes(std::vector<double> times)
{
    mTimes = std::move(times);
    mFrame = 0;
    mChosenMark.reset();
    setZoom(1.0);
}

void TimelineView::setSound(std::shared_ptr<const ClipSound> sound)
{
    mSound = sound && !sound->isEmpty() ? std::move(sound) : nullptr;
    updateScrollBars();
}

void TimelineView::setRows(QList<TimelineRow> rows)
{
    mRows = std::move(rows);
    if (mChosenMark) {
        const bool isThere = std::any_of(mRows.cbegin(), mRows.cend(), [this](const TimelineRow &row) {
            return row.id == mChosenMark->first && row.marks.contains(mChosenMark->second);
        });
        if (!isThere)
            mChosenMark.reset();
    }
    updateScrollBars();
}

void TimelineView::setFrame(int frame)
{
    if (frame == mFrame)
        return;
    mFrame = frame;
    // While the clip runs the line stays in sight.
    if (const double x = xOf(frame + 0.5);
        mDrag == Drag::None && (x < headerWidth || x > viewport()->width()))
        horizontalScrollBar()->setValue(int((frame - 1) * columnWidth()));
    viewport()->update();
}

void TimelineView::setChosenMark(std::optional<std::pair<int, TimelineMark>> mark)
{
    mChosenMark = std::move(mark);
    viewport()->update();
}

void TimelineView::setZoom(double zoom)
{
    const double most = std::max(1.0, frameCount() * 24.0 / std::max(1, viewport()->width() - headerWidth));
    const double kept = xOf(mFrame + 0.5) - headerWidth;
    mZoom = std::clamp(zoom, 1.0, most);
    updateScrollBars();
    horizontalScrollBar()->setValue(int((mFrame + 0.5) * columnWidth() - kept));
}

double TimelineView::columnWidth() const
{
    const int room = viewport()->width() - headerWidth - rightMargin;
    return frameCount() > 0 ? mZoom * std::max(1, room) / frameCount() : 1.0;
}

double TimelineView::xOf(double frame) const
{
    return headerWidth + frame * columnWidth() - horizontalScrollBar()->value();
}

int TimelineView::frameAt(double x) const
{
    const double frame = (x - headerWidth + horizontalScrollBar()->value()) / columnWidth();
    return std::clamp(int(std::floor(frame)), 0, std::max(0, frameCount() - 1));
}

int TimelineView::rowTop(int row) const
{
    return rulerHeight + row * rowHeight - verticalScrollBar()->value();
}

double TimelineView::markY(int row, TimelineMarkKind kind) const
{
    // Turns have a line of their own: both are often in one frame.
    return rowTop(row) + (kind == TimelineMarkKind::Turn ? 23.0 : 10.0);
}

void TimelineView::updateScrollBars()
{
    const int contentHeight = int(mRows.size()) * rowHeight + (mSound ? soundHeight : 0);
    const int roomHeight = viewport()->height() - rulerHeight;
    verticalScrollBar()->setRange(0, std::max(0, contentHeight - roomHeight));
    verticalScrollBar()->setPageStep(std::max(1, roomHeight));
    verticalScrollBar()->setSingleStep(rowHeight / 2);
    const int room = viewport()->width() - headerWidth - rightMargin;
    const int content = int(std::ceil(columnWidth() * frameCount()));
    horizontalScrollBar()->setRange(0, std::max(0, content - room));
    horizontalScrollBar()->setPageStep(std::max(1, room));
    viewport()->update();
}

QPoint TimelineView::placeOf(int row, const TimelineMark &mark) const
{
    return QPointF(xOf(mark.frame + 0.5), markY(row, mark.kind)).toPoint();
}

QPoint TimelineView::rulerPlace(int frame) const
{
    return {int(xOf(frame + 0.5)), rulerHeight / 2};
}

TimelineView::Hit TimelineView::hitAt(const QPoint &position) const
{
    Hit hit;
    if (position.y() < rulerHeight)
        return hit;
    const int row = (position.y() - rulerHeight + verticalScrollBar()->value()) / rowHeight;
    if (row < 0 || row >= mRows.size())
        return hit;
    hit.row = row;
    if (position.x() < headerWidth)
        return hit;
    double nearest = markReach;
    for (const TimelineMark &mark : mRows[row].marks) {
        const double dx = std::abs(xOf(mark.frame + 0.5) - position.x());
        const double dy = std::abs(markY(row, mark.kind) - position.y());
        if (dy <= markReach && dx <= nearest) {
            nearest = dx;
            hit.mark = mark;
        }
    }
    if (!hit.mark && position.y() > rowTop(row) + 30) {
        const int frame = frameAt(position.x());
        for (const TimelineDrawing &drawing : mRows[row].drawings)
            if (frame >= drawing.first && frame <= drawing.last)
                hit.drawing = drawing.index;
    }
    return hit;
}

// Near the present frame, that: keyframes usually belong where one looks.
int TimelineView::snapped(int frame, const Hit &dragged) const
{
    if (std::abs(frame - mFrame) <= snapFrames && columnWidth() < 8.0)
        frame = mFrame;
    // Two keyframes of one kind cannot share a frame: it stays where it was.
    for (const TimelineMark &mark : mRows[dragged.row].marks)
        if (mark.kind == dragged.mark->kind && mark.frame == frame && mark.frame != dragged.mark->frame)
            return mDragFrame;
    return frame;
}

void TimelineView::mousePressEvent(QMouseEvent *event)
{
    if (mTimes.empty())
        return;
    const QPoint position = event->position().toPoint();
    const Hit hit = hitAt(position);
    if (hit.row >= 0)
        emit rowChosen(mRows[hit.row].id);
    if (hit.mark && hit.row < mRows.size()) {
        setChosenMark(std::pair(mRows[hit.row].id, *hit.mark));
        emit markChosen(mRows[hit.row].id, *hit.mark);
        if (event->button() == Qt::RightButton) {
            emit markMenuRequested(mRows[hit.row].id, *hit.mark, event->globalPosition().toPoint());
            return;
        }
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (hit.mark) {
        mDrag = Drag::Mark;
        mDragged = hit;
        mDragFrame = hit.mark->frame;
        return;
    }
    if (hit.drawing)
        emit drawingChosen(mRows[hit.row].id, *hit.drawing);
    if (position.x() >= headerWidth) {
        setChosenMark(std::nullopt);
        mDrag = Drag::Scrub;
        emit scrubBegun();
        emit scrubbed(frameAt(position.x()));
    }
}

void TimelineView::mouseMoveEvent(QMouseEvent *event)
{
    const QPoint position = event->position().toPoint();
    if (mDrag == Drag::Scrub) {
        emit scrubbed(frameAt(position.x()));
    } else if (mDrag == Drag::Mark) {
        mDragFrame = snapped(frameAt(position.x()), mDragged);
        viewport()->update();
    } else {
        viewport()->setCursor(hitAt(position).mark ? Qt::SizeHorCursor : Qt::ArrowCursor);
    }
}

void TimelineView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const Drag ended = std::exchange(mDrag, Drag::None);
    if (ended == Drag::Scrub) {
        emit scrubEnded();
    } else if (ended == Drag::Mark && mDragged.row < mRows.size()) {
        const int id = mRows[mDragged.row].id;
        const TimelineMark mark = *mDragged.mark;
        if (mDragFrame != mark.frame) {
            TimelineMark moved = mark;
            moved.frame = mDragFrame;
            emit markMoved(id, mark, mDragFrame);
            setChosenMark(std::pair(id, moved));
        } else {
            emit scrubBegun();
            emit scrubbed(mark.frame); // a click goes there
            emit scrubEnded();
        }
    }
    viewport()->update();
}

void TimelineView::wheelEvent(QWheelEvent *event)
{
    if (event->modifiers() & Qt::ControlModifier) {
        setZoom(mZoom * std::pow(1.002, event->angleDelta().y()));
        event->accept();
        return;
    }
    if (event->modifiers() & Qt::ShiftModifier || horizontalScrollBar()->maximum() > 0) {
        const QPoint delta = event->angleDelta();
        const int way = delta.x() != 0 ? delta.x() : delta.y();
        horizontalScrollBar()->setValue(horizontalScrollBar()->value() - way);
        event->accept();
        return;
    }
    QAbstractScrollArea::wheelEvent(event);
}

void TimelineView::keyPressEvent(QKeyEvent *event)
{
    if ((event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) && mChosenMark) {
        const auto [id, mark] = *mChosenMark;
        emit markRemoveRequested(id, mark);
        return;
    }
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        int row = -1;
        for (int i = 0; i < mRows.size(); ++i)
            if (mRows[i].isChosen)
                row = i;
        row = std::clamp(row + (event->key() == Qt::Key_Up ? -1 : 1), 0, int(mRows.size()) - 1);
        if (row >= 0 && row < mRows.size())
            emit rowChosen(mRows[row].id);
        return;
    }
    QAbstractScrollArea::keyPressEvent(event);
}

void TimelineView::resizeEvent(QResizeEvent *)
{
    updateScrollBars();
}

void TimelineView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange)
        viewport()->update();
    QAbstractScrollArea::changeEvent(event);
}

QString TimelineView::toolTipAt(const QPoint &position) const
{
    const Hit hit = hitAt(position);
    if (hit.mark) {
        const QString where = tr("frame %1").arg(hit.mark->frame + 1);
        const QString then = hit.mark->interpolatesNext ? tr(", then straight to the next") : QString();
        switch (hit.mark->kind) {
        case TimelineMarkKind::Position:
            return tr("Pinned here, %1%2. Drag to another frame; Delete takes it away.").arg(where, then);
        case TimelineMarkKind::Depth:
            return tr("Distance set here, %1.").arg(where);
        case TimelineMarkKind::Turn:
            return tr("Turned here, %1%2.").arg(where, then);
        case TimelineMarkKind::Size:
            return tr("Size set here, %1.").arg(where);
        }
    }
    if (position.y() < rulerHeight)
        return tr("Drag to go through the clip. Ctrl and the wheel zoom.");
    if (hit.drawing)
        return tr("Drawing %1").arg(*hit.drawing + 1);
    return {};
}

bool TimelineView::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        const QString text = toolTipAt(help->pos());
        text.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), text, viewport());
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

} // namespace ductus
