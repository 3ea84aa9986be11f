// doodlestudio info and validate.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runInfoCommand(const QStringList &arguments);
ExitCode runValidateCommand(const QStringList &arguments);

} // namespace ductus
