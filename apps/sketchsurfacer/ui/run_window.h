// The desktop app: application, services and window. Everything with a display is behind this one function.
#pragma once

#include <QStringList>

namespace ductus {

/// Shows the window with \a files opened in it; the exit code when it is closed.
int runSurfacerWindow(int &argc, char **argv, const QStringList &files);

} // namespace ductus
