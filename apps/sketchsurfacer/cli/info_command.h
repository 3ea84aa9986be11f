// `sketchsurfacer info FILE`: what a project or a mesh holds, and whether it can be printed.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

/// \a arguments: those behind the command's name.
ExitCode runInfoCommand(const QStringList &arguments);

} // namespace ductus
