// `sketchsurfacer thumbnail P.ductus -o OUT.png`: a small picture of the sketch and its surface, without a
// display.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

/// \a arguments: without program and command.
ExitCode runThumbnailCommand(const QStringList &arguments);

} // namespace ductus
