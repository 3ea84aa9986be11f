#include "layerpainter/vr/window/run_window.h"

#include "layerpainter/vr/window/headset_window.h"
#include "widgets/run_window.h"

namespace ductus {

int runHeadsetWindow(int &argc, char **argv, const QStringList &files, bool inVr)
{
    const AppNames names{"layerpainter", "LayerPainter", "org.ductus.LayerPainter", DUCTUS_VERSION};
    if (inVr)
        return runWindow<HeadsetFirstWindow>(argc, argv, names, files);
    return runWindow<HeadsetWindow>(argc, argv, names, files);
}

} // namespace ductus
