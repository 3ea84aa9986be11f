// doodlestudio place: a painting of LayerPainter stands in a filmed scene.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runPlaceCommand(const QStringList &arguments);

} // namespace ductus
