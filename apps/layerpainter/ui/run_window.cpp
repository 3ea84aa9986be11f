#include "layerpainter/ui/run_window.h"

#include "layerpainter/ui/window/painter_window.h"
#include "widgets/run_window.h"

namespace ductus {

int runPainterWindow(int &argc, char **argv, const QStringList &files)
{
    return runWindow<PainterWindow>(
        argc, argv, {"layerpainter", "LayerPainter", "org.ductus.LayerPainter", DUCTUS_VERSION}, files);
}

} // namespace ductus
