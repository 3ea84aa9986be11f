// The window's panels once more, for the room: layers, brush and colour, tools. Same classes, same document,
// same brush; what is chosen here is chosen there.
#pragma once

#include "layerpainter/ui/window/painter_window.h"
#include "layerpainter/vr/panels/panel_rig.h"

class QCheckBox;
class QLabel;

namespace ductus {

class RoomPanels : public QObject
{
    Q_OBJECT
public:
    explicit RoomPanels(PainterWindow &window, QObject *parent = nullptr);

    PanelRig &rig() { return mRig; }
    LayerPanel &layers() { return *mLayers; }
    ColourPanel &colours() { return *mColours; }
    BrushPanel &brush() { return *mBrush; }
    /// Places of panels in the rig.
    static constexpr int layerPlace = 0, colourPlace = 1, toolPlace = 2;

    /// The layer whose row the pointer is on.
    std::optional<LayerId> hoveredLayer() const { return mHovered; }
    void setLeftHanded(bool leftHanded);
    /// A sentence at the foot of the tools: what was refused, that it was saved.
    void tell(const QString &text);

signals:
    void leftHandedWanted(bool leftHanded);
    void leaveWanted();
    /// The pointer came onto a button.
    void entered();

private:
    QWidget *makeColourPage();
    QWidget *makeToolPage();

    PainterWindow &mWindow;
    PanelRig mRig;
    LayerPanel *mLayers = nullptr;
    BrushPanel *mBrush = nullptr;
    ColourPanel *mColours = nullptr;
    QCheckBox *mLeftHanded = nullptr;
    QLabel *mTold = nullptr;
    std::optional<LayerId> mHovered;
};

} // namespace ductus
