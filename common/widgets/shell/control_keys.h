// Lets a focused control have the keys it works with before the window's shortcuts take them. Qt asks the
// focused widget first (QEvent::ShortcutOverride), but only text fields answer: without this, Down in a
// focused list of choices steps whatever the window binds to Down.
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

class QKeyEvent;

namespace ductus {

class ControlKeys : public QObject
{
    Q_OBJECT
public:
    /// Watches the controls in \a window, its pop-ups and docks.
    explicit ControlKeys(QWidget *window);

    /// Whether \a control, focused by a key if \a isFocusedByKey, works with the key: lists and choices with
    /// the arrows, sliders with arrows and Delete. Buttons take Space only if the user tabbed to them: after
    /// a click the window's Space (play) is meant.
    static bool takes(const QWidget *control, const QKeyEvent &key, bool isFocusedByKey);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *mWindow;
    QPointer<QObject> mFocusedByKey;
};

} // namespace ductus
