// Icons from our own resources, so that every machine shows the same: Breeze's (copied from the Debian
// package when building; names in icons.txt) and our own drawings (resources/icons). Drawn as SVG at every
// size and tinted from the application's palette at the moment they are painted, so they follow a change of
// theme.
#pragma once

#include <QIcon>
#include <QString>
#include <QStringList>

namespace ductus {

/// The icon \a name, our own first; a null icon for unknown names.
QIcon icon(const QString &name);

/// The same in one of the colours of messages and states instead of the text's.
enum class IconTint { Text, Accent, Success, Warning, Error, OnAccent };
QIcon icon(const QString &name, IconTint tint);

bool hasIcon(const QString &name);
/// All names, sorted.
QStringList iconNames();

} // namespace ductus
