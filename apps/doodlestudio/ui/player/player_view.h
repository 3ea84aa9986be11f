// PlayerView: the clip as it is filmed, as large as fits, with what the layers on it show, and the pen or
// mouse handed to the tool in use. Places on it are working pixels (doodling/reconstruction/shot.h).
#pragma once

#include "doodlestudio/ui/player/player_tool.h"

#include <QImage>
#include <QWidget>
#include <vector>

namespace ductus {

class PlayerView : public QWidget
{
    Q_OBJECT
public:
    explicit PlayerView(QWidget *parent = nullptr);

    /// The size of the working copy; nothing is shown while it is empty.
    void setWorkingSize(const QSize &size);
    const QSize &workingSize() const { return mWorkingSize; }
    /// The picture of the present frame, of any size.
    void setPicture(const QImage &picture);
    const QImage &picture() const { return mPicture; }

    /// Drawn over the picture in this order; they must outlive the view or be taken away.
    void addLayer(PlayerLayer *layer);
    /// Gets presses, drags and hovers; null: none.
    void setTool(PlayerTool *tool);
    PlayerTool *tool() const { return mTool; }
    /// A drag is going on: autosave waits for its end.
    bool isBusy() const { return mIsPressed; }
    /// Gives the drag up; false if there was none.
    bool cancelDrag();

    /// Where the whole picture lies, in the widget.
    QRectF pictureRect() const;
    QPointF toWorking(const QPointF &inView) const;
    QPointF toView(const QPointF &working) const;
    /// From working pixels to the widget's.
    QTransform viewFromWorking() const;
    /// Lengths: widget pixels a working pixel is wide.
    double zoom() const;

    /// What is shown right now, for thumbnails.
    QImage grabPicture() const;

    QSize sizeHint() const override { return {640, 360}; }
    QSize minimumSizeHint() const override { return {240, 160}; }

signals:
    /// The pointer moved over the picture; working pixels.
    void pointerMoved(const QPointF &working);
    void pointerLeft();
    void resized();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void tabletEvent(QTabletEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void press(const PointerState &pointer);
    void move(const PointerState &pointer);
    void release(const PointerState &pointer);
    PointerState pointerAt(const QPointF &position, double pressure, Qt::KeyboardModifiers modifiers,
                           bool isEraser, bool isPen) const;

    QSize mWorkingSize;
    QImage mPicture;
    std::vector<PlayerLayer *> mLayers;
    PlayerTool *mTool = nullptr;
    bool mIsPressed = false;
    double mZoom = 1.0;        // 1: fits
    QPointF mCentre{0.5, 0.5}; // share of the picture in the middle of the view
    bool mIsPanning = false;
    QPointF mPanFrom;
};

} // namespace ductus
