// Where an app keeps what must survive a crash but is no document: $XDG_STATE_HOME, by default ~/.local/state
// (XDG Base Directory Specification 0.8; QStandardPaths knows it only since Qt 6.7).
#pragma once

#include <QString>

namespace ductus {

/// The folder for \a application ("sketchsurfacer"), with \a name below it ("autosave"). Not made yet.
QString stateFolder(const QString &application, const QString &name);

} // namespace ductus
