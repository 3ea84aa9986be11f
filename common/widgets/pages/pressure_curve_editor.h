// PressureCurveEditor: the curve with its four points to drag, by mouse, pen or (Tab chooses none of them:
// left and right do, the arrows with Ctrl move it) by keys.
#pragma once

#include "document/settings/pressure_curve.h"

#include <QWidget>

namespace ductus {

class PressureCurveEditor : public QWidget
{
    Q_OBJECT
public:
    explicit PressureCurveEditor(QWidget *parent = nullptr);

    const PressureCurve &curve() const { return mCurve; }
    void setCurve(const PressureCurve &curve);
    /// A mark at the pressure of the pen now; negative: none.
    void setLivePressure(double pressure);

    QSize sizeHint() const override { return {240, 240}; }

signals:
    void curveChanged(const ductus::PressureCurve &curve);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QRectF field() const;
    QPointF toWidget(QPointF share) const;
    QPointF toShare(QPointF position) const;
    void moveSelected(QPointF to);

    PressureCurve mCurve;
    int mSelected = 1;
    bool mIsDragging = false;
    double mLive = -1.0;
};

} // namespace ductus
