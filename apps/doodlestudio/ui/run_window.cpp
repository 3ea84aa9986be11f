#include "doodlestudio/ui/run_window.h"

#include "doodlestudio/ui/window/studio_window.h"
#include "widgets/run_window.h"

namespace ductus {

int runStudioWindow(int &argc, char **argv, const QStringList &files)
{
    return runWindow<StudioWindow>(
        argc, argv, {"doodlestudio", "DoodleStudio", "org.ductus.DoodleStudio", DUCTUS_VERSION}, files);
}

} // namespace ductus
