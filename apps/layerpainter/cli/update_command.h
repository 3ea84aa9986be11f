// layerpainter update: takes over what has changed in the sketches a painting's surfaces were made from.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runUpdateCommand(const QStringList &arguments);

} // namespace ductus
