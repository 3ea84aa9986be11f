// layerpainter thumbnail P.ductus -o OUT.png: the painting as it is first seen, small. Also what file
// managers start.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runThumbnailCommand(const QStringList &arguments);

} // namespace ductus
