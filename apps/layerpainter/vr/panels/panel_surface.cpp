#include "layerpainter/vr/panels/panel_surface.h"

#include <QAbstractButton>
#include <QApplication>
#include <QHoverEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr double pixelsPerLogical = 2; // letters must be readable at arm's length

} // namespace

PanelSurface::PanelSurface(const QString &title, QWidget *content, int width, QObject *parent)
    : QObject(parent), mFrame(new QWidget)
{
    mFrame->setObjectName(QStringLiteral("panelFrame"));
    mFrame->setAttribute(Qt::WA_DontShowOnScreen);
    mFrame->setAttribute(Qt::WA_QuitOnClose, false); // nobody can close it
    mFrame->setAutoFillBackground(true);
    auto *layout = new QVBoxLayout(mFrame);
    layout->setContentsMargins(12, 10, 12, 12);
    auto *heading = new QLabel(title);
    QFont bold = heading->font();
    bold.setWeight(QFont::DemiBold);
    heading->setFont(bold);
    layout->addWidget(heading);
    layout->addWidget(content, 1);
    mFrame->setFixedWidth(width);
    mFrame->show();
    qApp->installEventFilter(this);
}

PanelSurface::~PanelSurface()
{
    qApp->removeEventFilter(this);
    delete mFrame;
}

bool PanelSurface::isOurs(const QObject *object) const
{
    for (; object; object = object->parent())
        if (object == mFrame)
            return true;
    return false;
}

bool PanelSurface::eventFilter(QObject *object, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Polish:
        // Lists that open belong on the panel, not on the desktop.
        if (auto *widget = qobject_cast<QWidget *>(object); widget && widget->isWindow() && isOurs(widget))
            widget->setAttribute(Qt::WA_DontShowOnScreen);
        break;
    case QEvent::UpdateRequest:
    case QEvent::LayoutRequest:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
        mIsStale |= isOurs(object);
        break;
    default:
        break;
    }
    return QObject::eventFilter(object, event);
}

QWidget *PanelSurface::popup() const
{
    QWidget *open = QApplication::activePopupWidget();
    return open && isOurs(open) ? open : nullptr;
}

const QImage &PanelSurface::image()
{
    if (!mIsStale)
        return mImage;
    mIsStale = false;
    const QSize pixels = size() * pixelsPerLogical;
    if (mImage.size() != pixels)
        mImage = QImage(pixels, QImage::Format_RGBA8888);
    mImage.setDevicePixelRatio(pixelsPerLogical);
    mImage.fill(Qt::transparent);
    QPainter painter(&mImage);
    mFrame->render(&painter);
    if (QWidget *open = popup()) {
        // What would stand out of the panel is moved onto it.
        const QRect room(QPoint(), size());
        QPoint at = open->mapToGlobal(QPoint()) - mFrame->mapToGlobal(QPoint());
        at.setX(std::max(0, std::min(at.x(), room.width() - open->width())));
        at.setY(std::max(0, std::min(at.y(), room.height() - open->height())));
        if (at != open->mapToGlobal(QPoint()) - mFrame->mapToGlobal(QPoint()))
            open->move(mFrame->mapToGlobal(QPoint()) + at);
        painter.translate(at);
        open->render(&painter);
    }
    painter.end();
    ++mImageNumber;
    return mImage;
}

QPointF PanelSurface::inWidget(const QWidget *widget, const QPointF &at) const
{
    return widget->mapFromGlobal(QPointF(mFrame->mapToGlobal(QPoint())) + at);
}

QWidget *PanelSurface::widgetAt(const QPointF &at) const
{
    if (QWidget *open = popup()) {
        const QPoint local = inWidget(open, at).toPoint();
        QWidget *child = open->childAt(local);
        return child ? child : open;
    }
    QWidget *child = mFrame->childAt(at.toPoint());
    return child ? child : mFrame;
}

void PanelSurface::hover(const QPointF &at)
{
    // A hand is never quite still; what does not matter need not be drawn anew.
    if (mHovered && (*mHovered - at).manhattanLength() < 1)
        return;
    mHovered = at;
    post(Act::Hover, at);
}

void PanelSurface::leave()
{
    if (!mHovered)
        return;
    mHovered.reset();
    post(Act::Leave, {-1, -1});
}

void PanelSurface::press(const QPointF &at)
{
    mIsPressed = true;
    post(Act::Press, at);
}

void PanelSurface::release(const QPointF &at)
{
    mIsPressed = false;
    post(Act::Release, at);
}

void PanelSurface::post(Act act, const QPointF &at)
{
    QTimer::singleShot(0, this, [this, act, at] { deliver(act, at); });
}

void PanelSurface::moveOnto(QWidget *widget, const QPointF &at)
{
    if (widget == mUnder)
        return;
    if (mUnder) {
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(mUnder, &leave);
        QHoverEvent away(QEvent::HoverLeave, QPointF(-1, -1), QPointF(-1, -1), QPointF(-1, -1));
        QApplication::sendEvent(mUnder, &away);
    }
    mUnder = widget;
    if (!widget)
        return;
    const QPointF local = inWidget(widget, at), global = widget->mapToGlobal(local);
    QEnterEvent enter(local, widget->window()->mapFromGlobal(global), global);
    QApplication::sendEvent(widget, &enter);
    QHoverEvent onto(QEvent::HoverEnter, local, global, QPointF(-1, -1));
    QApplication::sendEvent(widget, &onto);
    if (qobject_cast<QAbstractButton *>(widget) && widget->isEnabled())
        emit entered();
}

void PanelSurface::deliver(Act act, QPointF at)
{
    mIsStale = true; // whatever it does, it may show
    if (act == Act::Leave) {
        if (!mHeld)
            moveOnto(nullptr, at);
        return;
    }
    QWidget *under = widgetAt(at);
    if (act == Act::Press)
        mHeld = under;
    QWidget *target = mHeld ? mHeld.data() : under;
    if (!mHeld || act == Act::Press)
        moveOnto(under, at);
    const QPointF local = inWidget(target, at), global = target->mapToGlobal(local);
    const bool isDown = act == Act::Press || (act == Act::Hover && mHeld);
    const QEvent::Type type = act == Act::Press     ? QEvent::MouseButtonPress
                              : act == Act::Release ? QEvent::MouseButtonRelease
                                                    : QEvent::MouseMove;
    QMouseEvent event(type, local, target->window()->mapFromGlobal(global), global,
                      act == Act::Hover ? Qt::NoButton : Qt::LeftButton,
                      isDown ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
    if (act == Act::Release)
        mHeld = nullptr; // before: what is released may be deleted, or wait for more events
    QApplication::sendEvent(target, &event);
}

} // namespace ductus
