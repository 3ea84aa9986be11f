// PanelSurface: a widget that is on no screen: its picture hangs in the room, and what points at it there
// becomes pointer events of Qt.
#pragma once

#include <QImage>
#include <QPointer>
#include <QWidget>
#include <optional>

namespace ductus {

class PanelSurface : public QObject
{
    Q_OBJECT
public:
    /// Takes \a content, which gets a frame and a heading. \a width in logical pixels.
    PanelSurface(const QString &title, QWidget *content, int width, QObject *parent = nullptr);
    ~PanelSurface() override;

    QWidget &frame() { return *mFrame; }
    /// Logical pixels.
    QSize size() const { return mFrame->size(); }

    /// The picture, rows from the top; drawn again only if something changed.
    const QImage &image();
    /// Counts the pictures that were drawn.
    int imageNumber() const { return mImageNumber; }

    // Pointer events, in logical pixels of the frame. They are delivered from the event loop, not from inside
    // these calls: a menu that opens may stay for long.
    void hover(const QPointF &at);
    void leave();
    void press(const QPointF &at);
    void release(const QPointF &at);
    bool isPressed() const { return mIsPressed; }

signals:
    /// The pointer came onto something that can be pressed.
    void entered();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    enum class Act { Hover, Press, Release, Leave };
    void post(Act act, const QPointF &at);
    void deliver(Act act, QPointF at);
    QWidget *widgetAt(const QPointF &at) const;
    QWidget *popup() const;
    QPointF inWidget(const QWidget *widget, const QPointF &at) const;
    void moveOnto(QWidget *widget, const QPointF &at);
    bool isOurs(const QObject *object) const;

    QWidget *mFrame;
    QImage mImage;
    int mImageNumber = 0;
    bool mIsStale = true;
    bool mIsPressed = false;
    std::optional<QPointF> mHovered; // as posted last
    QPointer<QWidget> mUnder, mHeld;
};

} // namespace ductus
