// LayerPainter's window from main(): see widgets/run_window.h.
#pragma once

#include <QStringList>

namespace ductus {

/// The exit code. \a inVr: enters VR at once.
int runHeadsetWindow(int &argc, char **argv, const QStringList &files, bool inVr);

} // namespace ductus
