// StudioWindow: DoodleStudio's window: the shared shell filled with player, timeline, canvases and the
// drawing panel. Three steps that are always there - place, pin, draw - show where one is; they are no
// wizard.
#pragma once

#include "document/link_watcher.h"
#include "document/settings/recent_files.h"
#include "doodlestudio/document/action_log.h"
#include "doodlestudio/document/clip_opening.h"
#include "doodlestudio/document/doodle_document.h"
#include "doodlestudio/ui/canvases/canvas_layer.h"
#include "doodlestudio/ui/canvases/handles_tool.h"
#include "doodlestudio/ui/canvases/occlusion_tool.h"
#include "doodlestudio/ui/canvases/studio_state.h"
#include "doodlestudio/ui/drawing/direct_draw_tool.h"
#include "doodlestudio/ui/player/film_preview.h"
#include "doodlestudio/ui/player/frame_store.h"
#include "doodlestudio/ui/player/playback.h"
#include "widgets/main_window_shell.h"
#include "widgets/pages/unsaved_work.h"

class QSplitter;

namespace ductus {

struct PropLink;
class CanvasList;
class CanvasPanel;
class DrawingPanel;
class ExportDialog;
class PlayerView;
class SegmentedSwitch;
class TimelineView;
class TransportBar;

enum class StudioStep { Place, Pin, Draw };

class StudioWindow : public MainWindowShell
{
    Q_OBJECT
public:
    explicit StudioWindow(const ShellServices &services, QWidget *parent = nullptr);
    ~StudioWindow() override;

    DoodleDocument &doodle() { return mDoodle; }
    PlayerView &player() { return *mPlayer; }
    TimelineView &timeline() { return *mTimeline; }
    Playback &playback() { return mPlayback; }
    FrameStore &frames() { return mFrames; }
    TransportBar &transport() { return *mTransport; }
    StudioState &state() { return mState; }
    CanvasFollower &follower() { return mFollower; }
    HandlesTool &handles() { return mHandles; }
    CanvasPanel &canvasPanel() { return *mCanvasPanel; }
    DrawingPanel &drawing() { return *mDrawing; }
    FilmPreview &preview() { return mPreview; }
    UnsavedWork &unsavedWork() { return mUnsaved; }
    ActionLog &actionLog() { return mLog; }

    StudioStep step() const;
    void setStep(StudioStep step);

    /// A project, a video or a folder of pictures.
    void openPath(const QString &path);
    void openSample(const QString &id);
    void save();
    void saveAs();
    /// Finds out how the scene moves; drawing goes on meanwhile.
    void analyse();
    void packAnalysis(bool packs);
    /// The dialog that makes films; shown.
    ExportDialog *openExport();
    /// What was done since the log was turned on, a line of JSON an act.
    void saveActionLog(const QString &path);
    /// The lines drawn on the chosen canvas in the present drawing.
    void copyStrokes();
    /// Strokes of this or another app onto the chosen canvas, as one step of the history.
    void pasteStrokes();
    /// The painting of the project at \a path stands in the scene, on a canvas of its own.
    void placePainting(const QString &path);
    /// Looks whether paintings in the scene have changed and offers what is newer. \a isAsked: says also that
    /// nothing is, and offers again what was declined.
    void lookForNewerPaintings(bool isAsked);

signals:
    /// A clip is there and its first picture is shown.
    void clipShown();

protected:
    bool saveForClosing() override;

private:
    void addFileActions();
    void addPlayActions();
    void addCanvasActions();
    void addDrawingActions();
    void addLogActions();
    void fillInspector();
    void connectTimeline();
    void applyStep();
    void refreshRows();
    void goToKeyframe(int direction);
    void fillMenus();
    void buildCanvas();
    void fillStartPage();
    void refreshRecent();
    void connectParts();
    void chooseAndOpen();
    void openClipAt(const QString &path);
    void openProject(const QString &path);
    /// The clip of the document, after it was opened: where it was, or where it was moved to.
    void findClip();
    void openKnownClip(const QString &path);
    void lookForClip();
    void askForClip();
    void offerOtherClip(const QString &what, const QString &remedy);
    void adoptClip(OpenedClip clip);
    void showOpened();
    void saveTo(const QString &path, std::function<void(bool)> finish = {});
    QString askForPath();
    void showFrame(int frame);
    /// The present frame with or without the doodles in it, whichever is there.
    void showPicture();
    void onDocumentChanged(const ChangeEvent &event);
    void showSceneWords();
    void updatePictureSize();
    void openManual(const QString &topic);
    void choosePainting();
    /// Places the painting in the clip that is open, or in the next one.
    void takePainting(const QString &path);
    void standProp(Prop prop);
    void watchPaintings();
    void offerNewerPaintings(const std::vector<PropLink> &links, bool isAsked);

    DoodleDocument mDoodle;
    CanvasFollower mFollower;
    StudioState mState;
    HandlesTool mHandles;
    OcclusionTool mOcclusion;
    CanvasLayer mCanvases;
    DrawingHand mHand;
    DirectDrawTool mDirect;
    FrameStore mFrames;
    FilmPreview mPreview;
    Playback mPlayback;
    UnsavedWork mUnsaved;
    ActionLog mLog;
    RecentFiles mRecent;
    LinkWatcher mLinkWatcher;
    QString mPaintingToPlace; // when there is a clip
    QString mOffered; // the newer paintings last offered: once is enough
    SegmentedSwitch *mSteps = nullptr;
    QSplitter *mSplitter = nullptr;
    PlayerView *mPlayer = nullptr;
    TimelineView *mTimeline = nullptr;
    TransportBar *mTransport = nullptr;
    CanvasList *mCanvasList = nullptr;
    CanvasPanel *mCanvasPanel = nullptr;
    DrawingPanel *mDrawing = nullptr;
    QTimer mRowsTimer;        // gathers changes: rows are made once for all of them
    bool mWasPlaying = false; // before a scrub
};

} // namespace ductus
