// The window with everything it needs, until it is closed.
#pragma once

#include <QStringList>

namespace ductus {

/// \a files are opened at once. The exit code of the program.
int runStudioWindow(int &argc, char **argv, const QStringList &files);

} // namespace ductus
