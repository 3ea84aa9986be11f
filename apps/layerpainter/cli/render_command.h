// `layerpainter render IN -o OUT.png|.mp4|.webm|.gif|FOLDER`: a still or a film of a painting, without a
// display.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runRenderCommand(const QStringList &arguments);

} // namespace ductus
