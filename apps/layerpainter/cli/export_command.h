// `layerpainter export P -o X.glb`: the painting as a mesh, what its layers do baked into colours.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runExportCommand(const QStringList &arguments);

} // namespace ductus
