// `layerpainter import IN -o P.ductus`: another program's painting or mesh as a project.
#pragma once

#include "cli/exit_code.h"

#include <QStringList>

namespace ductus {

/// \a arguments after the word "import".
ExitCode runImportCommand(const QStringList &arguments);

} // namespace ductus
