// TimelineView: the clip from left to right, a row a canvas with its keyframes and drawings, the sound below.
// Scrub on the ruler or an empty place; drag a keyframe to move it; Ctrl and the wheel zoom.
#pragma once

#include "doodlestudio/ui/timeline/timeline_row.h"
#include "doodling/clip/clip_sound.h"

#include <QAbstractScrollArea>
#include <memory>
#include <optional>

namespace ductus {

class TimelineView : public QAbstractScrollArea
{
    Q_OBJECT
public:
    explicit TimelineView(QWidget *parent = nullptr);

    /// One time a frame, seconds.
    void setFrameTimes(std::vector<double> times);
    int frameCount() const { return int(mTimes.size()); }
    void setSound(std::shared_ptr<const ClipSound> sound);
    void setRows(QList<TimelineRow> rows);
    const QList<TimelineRow> &rows() const { return mRows; }
    void setFrame(int frame);
    int frame() const { return mFrame; }

    /// The keyframe last clicked, with the id of its row.
    std::optional<std::pair<int, TimelineMark>> chosenMark() const { return mChosenMark; }
    void setChosenMark(std::optional<std::pair<int, TimelineMark>> mark);

    /// 1: the whole clip fits.
    double zoom() const { return mZoom; }
    void setZoom(double zoom);
    bool isDragging() const { return mDrag != Drag::None; }

    /// The middle of a frame's column and of a row's marks, in the viewport: for tests and menus.
    QPoint placeOf(int row, const TimelineMark &mark) const;
    QPoint rulerPlace(int frame) const;

    QSize sizeHint() const override { return {600, 150}; }
    QSize minimumSizeHint() const override { return {200, 96}; }

signals:
    void scrubBegun();
    void scrubbed(int frame);
    void scrubEnded();
    void rowChosen(int id);
    /// Emitted at the end of a drag; \a frame differs from the mark's.
    void markMoved(int id, const ductus::TimelineMark &mark, int frame);
    void markChosen(int id, const ductus::TimelineMark &mark);
    void markMenuRequested(int id, const ductus::TimelineMark &mark, const QPoint &globalPosition);
    void markRemoveRequested(int id, const ductus::TimelineMark &mark);
    void drawingChosen(int id, int drawing);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool viewportEvent(QEvent *event) override;

private:
    enum class Drag { None, Scrub, Mark };
    struct Hit
    {
        int row = -1;
        std::optional<TimelineMark> mark;
        std::optional<int> drawing;
    };

    double columnWidth() const;
    double xOf(double frame) const;
    int frameAt(double x) const;
    int rowTop(int row) const;
    double markY(int row, TimelineMarkKind kind) const;
    Hit hitAt(const QPoint &position) const;
    int snapped(int frame, const Hit &dragged) const;
    void updateScrollBars();
    void paintRuler(QPainter &painter);
    void paintRow(QPainter &painter, int row);
    void paintMarks(QPainter &painter, int row);
    void paintSound(QPainter &painter, int top);
    QString toolTipAt(const QPoint &position) const;

    std::vector<double> mTimes;
    std::shared_ptr<const ClipSound> mSound;
    QList<TimelineRow> mRows;
    int mFrame = 0;
    double mZoom = 1.0;
    Drag mDrag = Drag::None;
    Hit mDragged;
    int mDragFrame = 0;
    std::optional<std::pair<int, TimelineMark>> mChosenMark;
};

} // namespace ductus
