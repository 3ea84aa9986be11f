#include "layerpainter/ui/panels/blend_names.h"

#include <QCoreApplication>

namespace ductus {

QString blendText(BlendMode mode)
{
    static const char *texts[blendModeCount] = {QT_TRANSLATE_NOOP("ductus::LayerPanel", "Normal"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Multiply"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Screen"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Overlay"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Add"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Darken"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Lighten"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Colour dodge"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Colour burn"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Hard light"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Soft light"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Difference"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Exclusion"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Hue"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Saturation"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Colour"),
                                                QT_TRANSLATE_NOOP("ductus::LayerPanel", "Luminosity")};
    return QCoreApplication::translate("ductus::LayerPanel", texts[int(mode)]);
}

} // namespace ductus
