// SurfacerWindow: SketchSurfacer's window: the shared shell filled with canvas, tools, inspector and actions.
#pragma once

#include "document/settings/recent_files.h"
#include "sketchsurfacer/document/sketch_import.h"
#include "sketchsurfacer/document/surfacing_jobs.h"
#include "sketchsurfacer/ui/window/export_dialog.h"
#include "sketchsurfacer/ui/window/tool_box.h"
#include "widgets/main_window_shell.h"
#include "widgets/pages/unsaved_work.h"

#include <QTimer>

class QActionGroup;

class QMimeData;

namespace ductus {

class AmbiguityPresenter;
class HelpWindow;
class MeasuresPanel;
class PrintPanel;
class RegionList;
class SegmentedSwitch;
class Turntable;

class SurfacerWindow : public MainWindowShell
{
    Q_OBJECT
public:
    explicit SurfacerWindow(const ShellServices &services, QWidget *parent = nullptr);
    ~SurfacerWindow() override;

    SketchDocument &sketch() { return mSketch; }
    SketchView &view() { return *mView; }
    SurfacingJobs &surfacing() { return mSurfacing; }
    ToolBox &tools() { return *mTools; }
    SketchPresenter &presenter() { return *mPresenter; }
    AmbiguityPresenter &ambiguity() { return *mAmbiguity; }
    PrintPanel &printCheck() { return *mPrint; }
    SegmentedSwitch &viewSwitch() { return *mSwitch; }
    UnsavedWork &unsavedWork() { return mUnsaved; }
    const RecentFiles &recentFiles() const { return mRecent; }

    /// A project, a sketch, or a mesh to be the proxy of the sketch that is open.
    void openPath(const QString &path);
    void openSample(const QString &id);
    /// Strokes of another app join the sketch as one step of the history; other text and files are opened.
    void pasteSketch();
    /// The chosen strokes, or all.
    void copyStrokes();
    void save();
    void saveAs();
    void exportSurface();
    /// Opens the project in LayerPainter, where its surface is what is painted on. What is not saved yet is
    /// asked to be.
    void sendToLayerPainter();
    /// Writes without a dialog.
    void exportTo(const QString &path, const ExportChoice &choice);
    /// What the canvas shows, as a PNG file.
    void savePicture(const QString &path);
    /// A round of \a count pictures in \a folder, turntable-000.png and so on.
    void saveTurntable(const QString &folder, int count);
    /// Surfaces, and shows preview and result as they come.
    void surfaceIt();

protected:
    bool saveForClosing() override;

private:
    void pasteStrokes(const QMimeData *data);
    void addActions();
    void addToolActions();
    void addViewActions();
    void fillMenus();
    void fillInspector();
    void fillStartPage();
    void connectParts();

    void newSketch();
    void chooseAndOpen();
    void openProject(const QString &path);
    void openSketch(const QString &title, std::function<Result<ImportedSketch>(const JobControl &)> read,
                    const QString &rememberedPath = {});
    void openProxy(const QString &path);
    void openManual(const QString &topic);
    void adoptSketch(ImportedSketch sketch);
    void showOpened();
    void saveTo(const QString &path, std::function<void(bool)> finish = {});
    QString askForPath();
    QImage picture();
    void refreshRecent();
    void refreshRecentPicture();

    void onDocumentChanged(const ChangeEvent &event);
    void onResultShown();
    void refreshSwitch();
    void refreshEmptyText();
    void escape();
    void showPointerText(const QPointF &position);
    void showMode(ViewMode mode);
    void showAmbiguity(bool on);
    void offerReadings(const QPointF &position);
    bool eventFilter(QObject *watched, QEvent *event) override;

    SketchDocument mSketch;
    SurfacingJobs mSurfacing;
    UnsavedWork mUnsaved;
    RecentFiles mRecent;
    QString mRecentPath; // of what is open; empty for samples and pasted sketches
    QTimer mPictureTimer;
    SketchView *mView = nullptr;
    SketchPresenter *mPresenter = nullptr;
    AmbiguityPresenter *mAmbiguity = nullptr;
    ToolBox *mTools = nullptr;
    SegmentedSwitch *mSwitch = nullptr;
    Turntable *mTurntable = nullptr;
    RegionList *mRegions = nullptr;
    MeasuresPanel *mMeasures = nullptr;
    PrintPanel *mPrint = nullptr;
    QActionGroup *mToolActions = nullptr;
    HelpWindow *mHelp = nullptr;
    std::vector<SampleSketch> mSamples;
    ExportChoice mExportChoice;
    bool mFollowsResult = false; // the user asked for a surface: the switch goes along
};

} // namespace ductus
