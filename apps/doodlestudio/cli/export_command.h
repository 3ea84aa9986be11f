// doodlestudio export P.ductus -o OUT.mp4: the clip with its doodles as a film.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runExportCommand(const QStringList &arguments);

} // namespace ductus
