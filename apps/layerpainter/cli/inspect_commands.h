// `layerpainter info P` and `layerpainter validate P`: what is in a project, and whether all of it is sound.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runInfoCommand(const QStringList &arguments);
ExitCode runValidateCommand(const QStringList &arguments);

} // namespace ductus
