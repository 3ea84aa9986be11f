// `doodlestudio analyse CLIP -o P.ductus`
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runAnalyseCommand(const QStringList &arguments);

} // namespace ductus
