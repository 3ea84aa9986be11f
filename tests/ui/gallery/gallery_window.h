// GalleryWindow: the shared window filled as an app would fill it.
#pragma once

#include "ui/gallery/gallery_document.h"
#include "widgets/main_window_shell.h"

namespace ductus {

class NumberSlider;
class SegmentedSwitch;

class GalleryWindow : public MainWindowShell
{
    Q_OBJECT
public:
    GalleryWindow(AppKind kind, const ShellServices &services);

    GalleryDocument &galleryDocument() { return mDocument; }
    SegmentedSwitch *views() { return mViews; }
    NumberSlider *tightness() { return mTightness; }
    /// A job that takes \a seconds.
    void startJob(double seconds);

private:
    void addActions();
    void fillInspector();
    void fillStrip();
    void fillStartPage();

    GalleryDocument mDocument;
    SegmentedSwitch *mViews = nullptr;
    NumberSlider *mTightness = nullptr;
    quint64 mDrag = 0;
};

/// "SketchSurfacer"
AppIdentity galleryIdentity(AppKind kind);

} // namespace ductus
