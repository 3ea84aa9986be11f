// `sketchsurfacer surface IN -o OUT`: the whole chain from the command line.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

/// \a arguments: what follows the word "surface".
ExitCode runSurfaceCommand(const QStringList &arguments);

} // namespace ductus
