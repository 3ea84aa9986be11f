#include "doodlestudio/ui/player/player_view.h"

#include "widgets/theme/theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double pictureMargin = 12.0;
constexpr double mostZoom = 12.0;

} // namespace

PlayerView::PlayerView(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("player"));
    setAccessibleName(tr("Player"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
}

void PlayerView::setWorkingSize(const QSize &size)
{
    mWorkingSize = size;
    mZoom = 1.0;
    mCentre = {0.5, 0.5};
    mPicture = {};
    update();
}

void PlayerView::setPicture(const QImage &picture)
{
    mPicture = picture;
    update();
}

void PlayerView::addLayer(PlayerLayer *layer)
{
    mLayers.push_back(layer);
    update();
}

void PlayerView::setTool(PlayerTool *tool)
{
    if (tool == mTool)
        return;
    cancelDrag();
    if (mTool)
        mTool->leave(*this);
    mTool = tool;
    unsetCursor();
    update();
}

bool PlayerView::cancelDrag()
{
    if (!mIsPressed || !mTool)
        return false;
    mIsPressed = false;
    mTool->cancel(*this);
    update();
    return true;
}

QRectF PlayerView::pictureRect() const
{
    if (mWorkingSize.isEmpty())
        return {};
    const QRectF room = QRectF(rect()).adjusted(pictureMargin, pictureMargin, -pictureMargin, -pictureMargin);
    const QSizeF fitting = QSizeF(mWorkingSize).scaled(room.size(), Qt::KeepAspectRatio);
    const QSizeF size = fitting * mZoom;
    const QPointF middle = room.center();
    return {middle.x() - mCentre.x() * size.width(), middle.y() - mCentre.y() * size.height(), size.width(),
            size.height()};
}

double PlayerView::zoom() const
{
    return mWorkingSize.isEmpty() ? 1.0 : pictureRect().width() / mWorkingSize.width();
}

QTransform PlayerView::viewFromWorking() const
{
    const QRectF picture = pictureRect();
    return QTransform::fromTranslate(picture.x(), picture.y()).scale(zoom(), zoom());
}

QPointF PlayerView::toWorking(const QPointF &inView) const
{
    return (inView - pictureRect().topLeft()) / zoom();
}

QPointF PlayerView::toView(const QPointF &working) const
{
    return pictureRect().topLeft() + working * zoom();
}

QImage PlayerView::grabPicture() const
{
    if (mPicture.isNull())
        return {};
    QImage image = mPicture.convertToFormat(QImage::Format_RGB32);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    // Layers draw in widget pixels: the picture's place in the widget becomes the whole image.
    const QRectF place = pictureRect();
    painter.scale(image.width() / place.width(), image.height() / place.height());
    painter.translate(-place.topLeft());
    for (PlayerLayer *layer : mLayers)
        layer->paint(painter, *this);
    return image;
}

void PlayerView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = coloursOf(palette());
    painter.fillRect(rect(), colours.isDark ? QColor(0x15, 0x17, 0x1a) : QColor(0xe4, 0xe6, 0xea));
    if (mWorkingSize.isEmpty())
        return;
    const QRectF place = pictureRect();
    if (mPicture.isNull()) {
        painter.fillRect(place, colours.panel);
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(place, mPicture);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (PlayerLayer *layer : mLayers)
        layer->paint(painter, *this);
    if (mTool)
        mTool->paint(painter, *this);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(colours.accent);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

PointerState PlayerView::pointerAt(const QPointF &position, double pressure, Qt::KeyboardModifiers modifiers,
                                   bool isEraser, bool isPen) const
{
    return {position, toWorking(position), pressure, modifiers, isEraser, isPen};
}

void PlayerView::press(const PointerState &pointer)
{
    if (!mTool || mWorkingSize.isEmpty())
        return;
    mIsPressed = true;
    mTool->press(pointer, *this);
}

void PlayerView::move(const PointerState &pointer)
{
    if (!mTool || mWorkingSize.isEmpty())
        return;
    if (mIsPressed)
        mTool->drag(pointer, *this);
    else
        mTool->hover(pointer, *this);
    emit pointerMoved(pointer.working);
}

void PlayerView::release(const PointerState &pointer)
{
    if (!mIsPressed || !mTool)
        return;
    mIsPressed = false;
    mTool->release(pointer, *this);
}

void PlayerView::mousePressEvent(QMouseEvent *event)
{
    setFocus(Qt::MouseFocusReason);
    if (event->button() == Qt::MiddleButton) {
        mIsPanning = true;
        mPanFrom = event->position();
    } else if (event->button() == Qt::LeftButton) {
        press(pointerAt(event->position(), 1.0, event->modifiers(), false, false));
    }
}

void PlayerView::mouseMoveEvent(QMouseEvent *event)
{
    if (mIsPanning) {
        const QPointF moved = event->position() - mPanFrom;
        mPanFrom = event->position();
        const QRectF picture = pictureRect();
        mCentre -= QPointF(moved.x() / picture.width(), moved.y() / picture.height());
        mCentre = {std::clamp(mCentre.x(), 0.0, 1.0), std::clamp(mCentre.y(), 0.0, 1.0)};
        update();
        return;
    }
    move(pointerAt(event->position(), 1.0, event->modifiers(), false, false));
}

void PlayerView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::MiddleButton)
        mIsPanning = false;
    else if (event->button() == Qt::LeftButton)
        release(pointerAt(event->position(), 1.0, event->modifiers(), false, false));
}

void PlayerView::tabletEvent(QTabletEvent *event)
{
    const PointerState pointer =
        pointerAt(event->position(), event->pressure(), event->modifiers(),
                  event->pointerType() == QPointingDevice::PointerType::Eraser, true);
    if (event->type() == QEvent::TabletPress && event->button() == Qt::LeftButton) {
        setFocus(Qt::MouseFocusReason);
        press(pointer);
    } else if (event->type() == QEvent::TabletMove) {
        move(pointer);
    } else if (event->type() == QEvent::TabletRelease && event->button() == Qt::LeftButton) {
        release(pointer);
    } else {
        event->ignore();
        return;
    }
    event->accept(); // or a mouse event would follow
}

void PlayerView::wheelEvent(QWheelEvent *event)
{
    if (mWorkingSize.isEmpty() || event->angleDelta().y() == 0)
        return;
    const QPointF under = toWorking(event->position());
    mZoom = std::clamp(mZoom * std::pow(1.0015, event->angleDelta().y()), 1.0, mostZoom);
    // What is under the pointer stays under it.
    const QPointF moved = toView(under) - event->position();
    const QRectF picture = pictureRect();
    mCentre += QPointF(moved.x() / picture.width(), moved.y() / picture.height());
    mCentre = mZoom <= 1.0 ? QPointF(0.5, 0.5)
                           : QPointF(std::clamp(mCentre.x(), 0.0, 1.0), std::clamp(mCentre.y(), 0.0, 1.0));
    update();
}

void PlayerView::leaveEvent(QEvent *)
{
    if (mTool && !mIsPressed)
        mTool->leave(*this);
    emit pointerLeft();
    update();
}

void PlayerView::resizeEvent(QResizeEvent *)
{
    emit resized();
}

void PlayerView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

} // namespace ductus
