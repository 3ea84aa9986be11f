// Walks a window by Tab as somebody without a mouse, or without sight, would, and tells what they could not
// use.
#pragma once

#include <QStringList>
#include <QWidget>

namespace ductus {

struct KeyboardWalk
{
    QStringList visited;  // accessible name and class of each stop, in order
    QStringList problems; // focusable without a name, focusable but never reached, a trap
};

/// Walks through the visible, enabled widgets of \a window, which must be shown and active (offscreen will
/// do).
KeyboardWalk walkByKeyboard(QWidget &window);

/// What a screen reader would call \a widget.
QString accessibleNameOf(const QWidget &widget);

} // namespace ductus
