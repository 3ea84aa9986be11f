// doodlestudio update: takes over what has changed in the paintings that stand in a filmed scene.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runUpdatePropsCommand(const QStringList &arguments);

} // namespace ductus
