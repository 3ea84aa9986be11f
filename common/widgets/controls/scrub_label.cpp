#include "widgets/controls/scrub_label.h"

#include <QMouseEvent>
#include <cmath>

namespace ductus {

namespace {

constexpr double startPixels = 3.0; // less is a click

} // namespace

ScrubLabel::ScrubLabel(const QString &text, QWidget *parent) : QLabel(text, parent)
{
    setCursor(Qt::SizeHorCursor);
}

void ScrubLabel::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    mIsPressed = true;
    mPressX = mLastX = event->globalPosition().x();
}

void ScrubLabel::mouseMoveEvent(QMouseEvent *event)
{
    if (!mIsPressed)
        return;
    const double x = event->globalPosition().x();
    if (!mIsScrubbing) {
        if (std::abs(x - mPressX) < startPixels)
            return;
        mIsScrubbing = true;
        emit scrubBegun();
    }
    const double fine = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.1 : 1.0;
    emit scrubbed((x - mLastX) * fine);
    mLastX = x;
}

void ScrubLabel::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    mIsPressed = false;
    if (!mIsScrubbing) {
        if (buddy())
            buddy()->setFocus(Qt::MouseFocusReason);
        return;
    }
    mIsScrubbing = false;
    emit scrubEnded();
}

void ScrubLabel::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        emit resetRequested();
}

} // namespace ductus
