#include "sketchsurfacer/ui/run_window.h"

#include "sketchsurfacer/ui/window/surfacer_window.h"
#include "widgets/run_window.h"

namespace ductus {

int runSurfacerWindow(int &argc, char **argv, const QStringList &files)
{
    return runWindow<SurfacerWindow>(
        argc, argv, {"sketchsurfacer", "SketchSurfacer", "org.ductus.SketchSurfacer", DUCTUS_VERSION}, files);
}

} // namespace ductus
