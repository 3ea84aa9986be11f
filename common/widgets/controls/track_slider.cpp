#include "widgets/controls/track_slider.h"

#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace ductus {

namespace {

constexpr double handleRadius = 7.0;
constexpr double trackHeight = 4.0;
constexpr int pageSteps = 10;

} // namespace

TrackSlider::TrackSlider(QWidget *parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TrackSlider::setShare(double share)
{
    mShare = std::clamp(share, 0.0, 1.0);
    update();
}

void TrackSlider::setDefaultShare(double share)
{
    mDefaultShare = share;
    update();
}

void TrackSlider::setValueText(const QString &text)
{
    if (mValueText == text)
        return;
    mValueText = text;
    QAccessibleValueChangeEvent event(this, text);
    QAccessible::updateAccessibility(&event);
}

double TrackSlider::xAt(double share) const
{
    return handleRadius + 1.0 + share * (width() - 2.0 * (handleRadius + 1.0));
}

double TrackSlider::shareAt(double x) const
{
    const double way = width() - 2.0 * (handleRadius + 1.0);
    return way <= 0.0 ? 0.0 : std::clamp((x - handleRadius - 1.0) / way, 0.0, 1.0);
}

void TrackSlider::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const double y = height() / 2.0;
    const double left = handleRadius + 1.0;
    const double right = width() - left;
    const double x = xAt(mShare);
    const QColor filled = isEnabled() ? colours.accent : colours.disabled;
    painter.setBrush(mixed(colours.line, colours.dim, 0.2));
    painter.drawRoundedRect(QRectF(left, y - trackHeight / 2.0, right - left, trackHeight), 2.0, 2.0);
    painter.setBrush(filled);
    painter.drawRoundedRect(QRectF(left, y - trackHeight / 2.0, x - left, trackHeight), 2.0, 2.0);
    if (mDefaultShare >= 0.0 && isEnabled()) {
        painter.setBrush(colours.dim);
        painter.drawRoundedRect(QRectF(xAt(mDefaultShare) - 1.0, y + 5.0, 2.0, 4.0), 1.0, 1.0);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.accent, 1.5));
        painter.drawEllipse(QPointF(x, y), handleRadius + 0.75, handleRadius + 0.75);
        painter.setPen(Qt::NoPen);
    }
    const QColor knob = colours.isDark ? colours.text : colours.panel;
    painter.setBrush(isEnabled() ? (mIsDragging ? filled : knob) : colours.line);
    painter.setPen(colours.isDark ? Qt::NoPen : QPen(isEnabled() ? colours.dim : colours.line, 1.0));
    const double radius = mIsHovered || mIsDragging ? handleRadius - 0.5 : handleRadius - 1.5;
    painter.drawEllipse(QPointF(x, y), radius, radius);
}

void TrackSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    mIsDragging = true;
    emit dragBegun();
    // A press on the handle must not move it.
    if (std::abs(event->position().x() - xAt(mShare)) > handleRadius)
        emit dragged(shareAt(event->position().x()));
    update();
}

void TrackSlider::mouseMoveEvent(QMouseEvent *event)
{
    if (mIsDragging)
        emit dragged(shareAt(event->position().x()));
}

void TrackSlider::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !mIsDragging)
        return;
    mIsDragging = false;
    emit dragEnded();
    update();
}

void TrackSlider::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        emit resetRequested();
}

void TrackSlider::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        emit stepped(-1);
        break;
    case Qt::Key_Right:
    case Qt::Key_Up:
        emit stepped(1);
        break;
    case Qt::Key_PageDown:
        emit stepped(-pageSteps);
        break;
    case Qt::Key_PageUp:
        emit stepped(pageSteps);
        break;
    case Qt::Key_Home:
        emit endRequested(false);
        break;
    case Qt::Key_End:
        emit endRequested(true);
        break;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        emit resetRequested();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void TrackSlider::enterEvent(QEnterEvent *)
{
    mIsHovered = true;
    update();
}

void TrackSlider::leaveEvent(QEvent *)
{
    mIsHovered = false;
    update();
}

} // namespace ductus
