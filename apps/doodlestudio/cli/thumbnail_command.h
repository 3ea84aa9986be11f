// doodlestudio thumbnail P.ductus -o OUT.png: one frame with its doodles, small.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runThumbnailCommand(const QStringList &arguments);

} // namespace ductus
