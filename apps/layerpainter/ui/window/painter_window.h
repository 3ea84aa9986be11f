// PainterWindow: LayerPainter's window: the shared shell filled with canvas, tools, layers and looks.
#pragma once

#include "document/settings/recent_files.h"
#include "layerpainter/document/import_file.h"
#include "layerpainter/ui/panels/brush_panel.h"
#include "layerpainter/ui/panels/colour_panel.h"
#include "layerpainter/ui/panels/layer_panel.h"
#include "layerpainter/ui/panels/looks_bar.h"
#include "widgets/main_window_shell.h"
#include "widgets/pages/unsaved_work.h"

class QActionGroup;

namespace ductus {

enum class PainterTool { Orbit, Select, Move, Paint, Erase, Gradient };

class PainterWindow : public MainWindowShell
{
    Q_OBJECT
public:
    explicit PainterWindow(const ShellServices &services, QWidget *parent = nullptr);
    ~PainterWindow() override;

    PaintingDocument &painting() { return mPainting; }
    PaintingView &view() { return *mView; }
    LayerPanel &layers() { return *mLayers; }
    BrushState &brush() { return mBrush; }
    PainterTool tool() const { return mTool; }
    void setTool(PainterTool tool);

    /// A project, or a painting or mesh of another program.
    void openPath(const QString &path);
    void openSample(const QString &id);
    void newPainting();
    void save();
    void saveAs();
    /// Writes without a dialog.
    void exportPicture(const QString &path);
    void saveActionLog(const QString &path);

protected:
    bool saveForClosing() override;

private:
    void addActions();
    void addToolActions();
    void fillMenus();
    void fillInspector();
    void fillStartPage();
    void connectParts();
    void chooseAndOpen();
    void chooseExport();
    void chooseLogFile();
    void openProject(const QString &path);
    void adopt(ImportedFile file, const QString &source);
    void showOpened();
    void saveTo(const QString &path, std::function<void(bool)> finish = {});
    QString askForPath();
    void refreshRecent();
    void onDocumentChanged(const ChangeEvent &event);
    void setActiveLayer(LayerId layer);
    void deleteSelection();
    void duplicateSelection();
    void showPointerText(const QPointF &position);
    void escape();

    PaintingDocument mPainting;
    BrushState mBrush;
    UnsavedWork mUnsaved;
    RecentFiles mRecent;
    PaintingView *mView = nullptr;
    LayerPanel *mLayers = nullptr;
    BrushPanel *mBrushPanel = nullptr;
    ColourPanel *mColours = nullptr;
    QActionGroup *mToolActions = nullptr;
    PainterTool mTool = PainterTool::Orbit;
    PaintTool mPaintTool;
    EraseTool mEraseTool;
    SelectTool mSelectTool;
    MoveTool mMoveTool;
    GradientTool mGradientTool;
};

} // namespace ductus
