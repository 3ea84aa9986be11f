// `layerpainter render IN -o OUT.png`: a still of a painting, without display or graphics card.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

ExitCode runRenderCommand(const QStringList &arguments);

} // namespace ductus
