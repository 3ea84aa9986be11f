// `doodlestudio track P.ductus --queries Q.json -o T.json`
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runTrackCommand(const QStringList &arguments);

} // namespace ductus
