#include "widgets/pages/pressure_curve_editor.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

namespace ductus {

namespace {

constexpr double margin = 12.0;
constexpr double keyStep = 0.02;

} // namespace

PressureCurveEditor::PressureCurveEditor(QWidget *parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Pressure curve"));
    setAccessibleDescription(tr("Left and right choose a point, Ctrl with the arrow keys moves it."));
    setToolTip(tr("Drag the points. Left: a light touch, right: pressed hard; up: counts more."));
    setMinimumSize(200, 200);
}

void PressureCurveEditor::setCurve(const PressureCurve &curve)
{
    mCurve = curve;
    update();
}

void PressureCurveEditor::setLivePressure(double pressure)
{
    mLive = pressure;
    update();
}

QRectF PressureCurveEditor::field() const
{
    const double side = std::min(width(), height()) - 2.0 * margin;
    return {margin, margin, side, side};
}

QPointF PressureCurveEditor::toWidget(QPointF share) const
{
    const QRectF f = field();
    return {f.left() + share.x() * f.width(), f.bottom() - share.y() * f.height()};
}

QPointF PressureCurveEditor::toShare(QPointF position) const
{
    const QRectF f = field();
    return {(position.x() - f.left()) / f.width(), (f.bottom() - position.y()) / f.height()};
}

void PressureCurveEditor::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF f = field();
    painter.setPen(QPen(hasFocus() ? colours.accent : colours.line, 1.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(f.adjusted(-11.5, -11.5, 11.5, 11.5), 6.0, 6.0);
    painter.setPen(QPen(colours.line, 1.0));
    for (int i = 1; i < 4; ++i) {
        painter.drawLine(QPointF(f.left() + f.width() * i / 4, f.top()),
                         QPointF(f.left() + f.width() * i / 4, f.bottom()));
        painter.drawLine(QPointF(f.left(), f.top() + f.height() * i / 4),
                         QPointF(f.right(), f.top() + f.height() * i / 4));
    }
    QPainterPath path;
    constexpr int samples = 128;
    for (int i = 0; i <= samples; ++i) {
        const double x = i / double(samples);
        const QPointF at = toWidget({x, mCurve.map(x)});
        i == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.accent, 2.0));
    painter.drawPath(path);
    if (mLive >= 0.0) {
        const QPointF at = toWidget({mLive, mCurve.map(mLive)});
        painter.setPen(QPen(colours.dim, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(at.x(), f.bottom()), at);
        painter.drawLine(QPointF(f.left(), at.y()), at);
    }
    for (int i = 0; i < PressureCurve::pointCount; ++i) {
        const bool isSelected = i == mSelected && (hasFocus() || mIsDragging);
        painter.setPen(QPen(colours.accent, 2.0));
        painter.setBrush(isSelected ? colours.accent : colours.panel);
        painter.drawEllipse(toWidget(mCurve.points()[std::size_t(i)]), 5.0, 5.0);
    }
}

void PressureCurveEditor::moveSelected(QPointF to)
{
    mCurve.movePoint(mSelected, to);
    update();
    emit curveChanged(mCurve);
}

void PressureCurveEditor::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    double nearest = 1e9;
    for (int i = 0; i < PressureCurve::pointCount; ++i) {
        const QPointF way = toWidget(mCurve.points()[std::size_t(i)]) - event->position();
        if (std::hypot(way.x(), way.y()) < nearest) {
            nearest = std::hypot(way.x(), way.y());
            mSelected = i;
        }
    }
    mIsDragging = true;
    moveSelected(toShare(event->position()));
}

void PressureCurveEditor::mouseMoveEvent(QMouseEvent *event)
{
    if (mIsDragging)
        moveSelected(toShare(event->position()));
}

void PressureCurveEditor::mouseReleaseEvent(QMouseEvent *)
{
    mIsDragging = false;
    update();
}

void PressureCurveEditor::keyPressEvent(QKeyEvent *event)
{
    const int dx = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    const int dy = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (event->modifiers().testFlag(Qt::ControlModifier) && (dx != 0 || dy != 0)) {
        moveSelected(mCurve.points()[std::size_t(mSelected)] + QPointF(dx, dy) * keyStep);
    } else if (dx != 0) {
        mSelected = std::clamp(mSelected + dx, 0, PressureCurve::pointCount - 1);
        update();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace ductus
