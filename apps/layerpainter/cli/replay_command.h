// `layerpainter replay LOG.jsonl -o P.ductus`: an action log, or a script of actions, becomes a painting.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runReplayCommand(const QStringList &arguments);

} // namespace ductus
