#include "widgets/testing/keyboard_walk.h"

#include <QAccessible>
#include <QApplication>
#include <QKeyEvent>
#include <QScrollBar>
#include <set>

namespace ductus {

namespace {

constexpr int mostStops = 2000; // more is a trap

QString described(const QWidget &widget)
{
    QString text = QString::fromLatin1(widget.metaObject()->className());
    if (!widget.objectName().isEmpty())
        text += QLatin1Char('#') + widget.objectName();
    return text;
}

// Whether somebody would expect to come to \a widget by Tab.
bool isExpected(const QWidget &widget, const QWidget &window)
{
    if (!widget.isVisibleTo(&window) || !widget.isEnabled() || widget.window() != &window ||
        widget.focusProxy())
        return false;
    // Alt and F10 lead to menu bars.
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && !widget.inherits("QMenuBar");
}

void pressTab(QWidget &window)
{
    QWidget *focus = window.focusWidget() ? window.focusWidget() : &window;
    QKeyEvent press(QEvent::KeyPress, Qt::Key_Tab, Qt::NoModifier, QStringLiteral("\t"));
    QApplication::sendEvent(focus, &press);
    QKeyEvent release(QEvent::KeyRelease, Qt::Key_Tab, Qt::NoModifier, QStringLiteral("\t"));
    QApplication::sendEvent(focus, &release);
}

} // namespace

QString accessibleNameOf(const QWidget &widget)
{
    // Not QAccessible's answer alone: it gives a window's title or a field's content as a name.
    if (!widget.accessibleName().isEmpty())
        return widget.accessibleName();
    if (QAccessibleInterface *interface =
            QAccessible::queryAccessibleInterface(const_cast<QWidget *>(&widget)))
        return interface->text(QAccessible::Name);
    return {};
}

KeyboardWalk walkByKeyboard(QWidget &window)
{
    KeyboardWalk walk;
    std::set<const QWidget *> reached;
    for (int i = 0; i < mostStops; ++i) {
        pressTab(window);
        const QWidget *focus = window.focusWidget();
        if (!focus) {
            walk.problems << QStringLiteral("Tab reaches nothing");
            return walk;
        }
        if (!reached.insert(focus).second)
            break;
        const QString name = accessibleNameOf(*focus).trimmed();
        walk.visited << QStringLiteral("%1 (%2)").arg(name, described(*focus));
        if (name.isEmpty())
            walk.problems << QStringLiteral("no accessible name: %1").arg(described(*focus));
    }
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (isExpected(*widget, window) && reached.count(widget) == 0)
            walk.problems << QStringLiteral("not reached by Tab: %1 \"%2\"")
                                 .arg(described(*widget), accessibleNameOf(*widget));
    }
    return walk;
}

} // namespace ductus
