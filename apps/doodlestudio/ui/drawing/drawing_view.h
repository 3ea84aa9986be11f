// DrawingView: the chosen canvas seen straight from the front, the film below it, the drawings before and
// after shining through.
#pragma once

#include "doodlestudio/ui/drawing/drawing_hand.h"

#include <QWidget>

namespace ductus {

class DrawingView : public QWidget
{
    Q_OBJECT
public:
    DrawingView(StudioState &state, DrawingHand &hand, QWidget *parent = nullptr);

    /// The film's present frame, of any size.
    void setPicture(const QImage &picture);
    /// How much of the film is seen, 0..1.
    void setUnderlay(double share);

    /// Where the whole sheet is, in the widget.
    QRectF sheetRect() const;
    QPointF toView(const Vec2 &onCanvas) const;
    Vec2 toCanvas(const QPointF &inView) const;

    QSize sizeHint() const override { return {420, 420}; }
    QSize minimumSizeHint() const override { return {260, 140}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void tabletEvent(QTabletEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QTransform viewFromCanvas() const;
    void paintUnderlay(QPainter &painter, const Canvas &canvas);
    void paintOnion(QPainter &painter, const Canvas &canvas);

    StudioState &mState;
    DrawingHand &mHand;
    QImage mPicture;
    double mUnderlay = 0.75;
    std::optional<QPointF> mPointer;
};

} // namespace ductus
