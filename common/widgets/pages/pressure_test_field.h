// PressureTestField: a patch of paper to try the pen on: strokes as wide as the mapped pressure. The eraser
// end wipes.
#pragma once

#include "document/settings/pressure_curve.h"

#include <QImage>
#include <QWidget>

namespace ductus {

class PressureTestField : public QWidget
{
    Q_OBJECT
public:
    explicit PressureTestField(QWidget *parent = nullptr);

    void setCurve(const PressureCurve &curve) { mCurve = curve; }
    void clear();
    bool isEmpty() const { return mStrokes.isEmpty(); }

    QSize sizeHint() const override { return {240, 240}; }

signals:
    /// Of the pen on the field now; negative once it is lifted.
    void pressureChanged(double pressure);

protected:
    void paintEvent(QPaintEvent *event) override;
    void tabletEvent(QTabletEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    struct Dot
    {
        QPointF position;
        double pressure = 0.0;
        bool isFirst = false;
    };

    void add(QPointF position, double pressure, bool isFirst);

    PressureCurve mCurve;
    QList<Dot> mStrokes;
};

} // namespace ductus
