// HeadsetWindow: LayerPainter's window with a button that enters VR.
#pragma once

#include "layerpainter/vr/mode/vr_mode.h"

namespace ductus {

class HeadsetWindow : public PainterWindow
{
    Q_OBJECT
public:
    explicit HeadsetWindow(const ShellServices &services, QWidget *parent = nullptr);
    ~HeadsetWindow() override;

    VrMode &vr() { return *mVr; }
    /// A message says what is missing if it cannot be.
    void enterVr();

private:
    void onEnded(const QString &error);

    std::unique_ptr<VrMode> mVr;
    QAction *mAction = nullptr;
};

/// Enters VR as soon as it is shown.
class HeadsetFirstWindow : public HeadsetWindow
{
    Q_OBJECT
public:
    explicit HeadsetFirstWindow(const ShellServices &services, QWidget *parent = nullptr);
};

} // namespace ductus
