// PainterWindow: LayerPainter's window: the shared shell filled with canvas, tools, layers and looks.
#pragma once

#include "document/link_watcher.h"
#include "document/linked_app.h"
#include "document/settings/recent_files.h"
#include "layerpainter/document/import_file.h"
#include "layerpainter/document/surface_update.h"
#include "layerpainter/ui/panels/brush_panel.h"
#include "layerpainter/ui/panels/colour_panel.h"
#include "layerpainter/ui/panels/layer_panel.h"
#include "layerpainter/ui/panels/looks_bar.h"
#include "layerpainter/ui/panels/motion_bar.h"
#include "layerpainter/ui/point/colour_list.h"
#include "layerpainter/ui/tools/transform_tool.h"
#include "widgets/main_window_shell.h"
#include "widgets/pages/unsaved_work.h"

class QActionGroup;

namespace ductus {

struct FilmChoice;
struct FrameOptions;

enum class PainterTool { Orbit, Select, Move, Paint, Erase, Gradient, Inspect };

class PainterWindow : public MainWindowShell
{
    Q_OBJECT
public:
    explicit PainterWindow(const ShellServices &services, QWidget *parent = nullptr);
    ~PainterWindow() override;

    PaintingDocument &painting() { return mPainting; }
    PaintingView &view() { return *mView; }
    LayerPanel &layers() { return *mLayers; }
    BrushPanel &brushPanel() { return *mBrushPanel; }
    ColourPanel &colourPanel() { return *mColours; }
    BrushState &brush() { return mBrush; }
    MotionBar &motion() { return *mMotion; }
    ColourList &colourList() { return *mColourList; }
    PainterTool tool() const { return mTool; }
    void setTool(PainterTool tool);

    /// A project, or a painting or mesh of another program.
    void openPath(const QString &path);
    void openSample(const QString &id);
    void newPainting();
    /// The file's stacks join the painting that is open, as one step of the history.
    void importPath(const QString &path);
    void save();
    void saveAs();
    /// What the canvas shows, drawn anew in the background: as large as \a options say.
    void exportPicture(const QString &path, const FrameOptions &options);
    /// In the background; what is written or why not is told by a message.
    void exportFilm(const QString &path, const FilmChoice &choice);
    void exportMesh(const QString &path);
    void saveActionLog(const QString &path);
    /// The chosen strokes; nothing chosen: says so.
    void copyStrokes();
    /// Into the active layer, as one step of the history.
    void pasteStrokes();
    /// A sketch of the chosen strokes, or of the active layer, in a project beside this one.
    void sendToSketchSurfacer();
    void sendToDoodleStudio();
    /// Looks whether the sketches behind surfaces have changed and offers what is newer. \a isAsked: says also
    /// that nothing is, and offers again what was declined.
    void lookForNewerSurfaces(bool isAsked);

protected:
    bool saveForClosing() override;

private:
    void addActions();
    void addToolActions();
    void addExchangeActions();
    void fillMenus();
    void fillInspector();
    void fillStartPage();
    void connectParts();
    void chooseAndOpen();
    void chooseImport();
    void takeDropped(const QStringList &paths);
    void chooseExport();
    void chooseFilm();
    void chooseMesh();
    void chooseLogFile();
    void openProject(const QString &path);
    void adopt(ImportedFile file, const QString &source);
    void showOpened();
    void saveTo(const QString &path, std::function<void(bool)> finish = {});
    QString askForPath();
    void refreshRecent();
    void offerNewerSurfaces(const std::vector<SurfaceLink> &links, bool isAsked);
    void open(LinkedApp app, const QString &path);
    void paintOnSurfacesOf(const QString &path);
    void updateFromSketches(const std::vector<SurfaceLink> &links);
    void onDocumentChanged(const ChangeEvent &event);
    void setActiveLayer(LayerId layer);
    void deleteSelection();
    void duplicateSelection();
    void showPointerText(const QPointF &position);
    void showColoursAt(const QPointF &position);
    void setMotionShown(bool shown);
    void openManual(const QString &topic);
    void escape();

    PaintingDocument mPainting;
    BrushState mBrush;
    UnsavedWork mUnsaved;
    RecentFiles mRecent;
    LinkWatcher mLinkWatcher;
    QString mOffered; // the newer surfaces last offered: once is enough
    PaintingView *mView = nullptr;
    LayerPanel *mLayers = nullptr;
    BrushPanel *mBrushPanel = nullptr;
    ColourPanel *mColours = nullptr;
    MotionBar *mMotion = nullptr;
    ColourList *mColourList = nullptr;
    PointColours mPointColours;
    QActionGroup *mToolActions = nullptr;
    PainterTool mTool = PainterTool::Orbit;
    PaintTool mPaintTool;
    EraseTool mEraseTool;
    SelectTool mSelectTool;
    TransformTool mMoveTool;
    GradientTool mGradientTool;
    InspectTool mInspectTool;
};

} // namespace ductus
