#include "widgets/shell/control_keys.h"

#include "widgets/controls/track_slider.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace ductus {

namespace {

bool isUpOrDown(int key)
{
    return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown;
}

bool isAlong(int key)
{
    return isUpOrDown(key) || key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home ||
           key == Qt::Key_End;
}

} // namespace

ControlKeys::ControlKeys(QWidget *window) : QObject(window), mWindow(window)
{
    qApp->installEventFilter(this);
}

bool ControlKeys::takes(const QWidget *control, const QKeyEvent &key, bool isFocusedByKey)
{
    if (key.modifiers() & ~Qt::KeypadModifier)
        return false;
    const int code = key.key();
    if (qobject_cast<const QComboBox *>(control))
        return isUpOrDown(code) || code == Qt::Key_Home || code == Qt::Key_End ||
               (code == Qt::Key_Space && isFocusedByKey);
    if (qobject_cast<const TrackSlider *>(control))
        return isAlong(code) || code == Qt::Key_Delete || code == Qt::Key_Backspace;
    if (qobject_cast<const QAbstractItemView *>(control))
        return isAlong(code) || (code == Qt::Key_Space && isFocusedByKey);
    if (qobject_cast<const QAbstractSlider *>(control))
        return isAlong(code);
    if (qobject_cast<const QAbstractSpinBox *>(control))
        return isUpOrDown(code);
    if (qobject_cast<const QAbstractButton *>(control))
        return code == Qt::Key_Space && isFocusedByKey;
    return false;
}

bool ControlKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (!watched->isWidgetType())
        return false; // the style is told of the focus too
    if (event->type() == QEvent::FocusIn) {
        const Qt::FocusReason reason = static_cast<QFocusEvent *>(event)->reason();
        if (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason)
            mFocusedByKey = watched;
        else if (reason == Qt::MouseFocusReason)
            mFocusedByKey = nullptr;
    } else if (event->type() == QEvent::MouseButtonPress && watched == mFocusedByKey) {
        mFocusedByKey = nullptr; // clicked where the focus was already
    } else if (event->type() == QEvent::ShortcutOverride) {
        const auto *control = static_cast<const QWidget *>(watched);
        if (control->window() == mWindow && control->hasFocus() &&
            takes(control, *static_cast<QKeyEvent *>(event), watched == mFocusedByKey)) {
            event->accept();
            return true;
        }
    }
    return false;
}

} // namespace ductus
