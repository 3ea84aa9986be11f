// StudioWindow: DoodleStudio's window: the shared shell filled with player, timeline, canvases and the
// drawing panel. Three steps that are always there - place, pin, draw - show where one is; they are no
// wizard.
#pragma once

#include "document/settings/recent_files.h"
#include "doodlestudio/document/clip_opening.h"
#include "doodlestudio/document/doodle_document.h"
#include "doodlestudio/ui/player/frame_store.h"
#include "doodlestudio/ui/player/playback.h"
#include "widgets/main_window_shell.h"
#include "widgets/pages/unsaved_work.h"

class QSplitter;

namespace ductus {

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

    StudioStep step() const;
    void setStep(StudioStep step);

    /// A project, a video or a folder of pictures.
    void openPath(const QString &path);
    void openSample(const QString &path);
    void save();
    void saveAs();
    /// Finds out how the scene moves; drawing goes on meanwhile.
    void analyse();

signals:
    /// A clip is there and its first picture is shown.
    void clipShown();

protected:
    bool saveForClosing() override;

private:
    void addFileActions();
    void addPlayActions();
    void fillMenus();
    void buildCanvas();
    void fillStartPage();
    void refreshRecent();
    void connectParts();
    void chooseAndOpen();
    void openClipAt(const QString &path);
    void openProject(const QString &path);
    /// The clip of the document, after it was opened.
    void findClip();
    void lookForClip();
    void adoptClip(OpenedClip clip);
    void showOpened();
    void saveTo(const QString &path, std::function<void(bool)> finish = {});
    QString askForPath();
    void showFrame(int frame);
    void onDocumentChanged(const ChangeEvent &event);
    void showSceneWords();
    void updatePictureSize();
    void openManual(const QString &topic);

    DoodleDocument mDoodle;
    FrameStore mFrames;
    Playback mPlayback;
    UnsavedWork mUnsaved;
    RecentFiles mRecent;
    SegmentedSwitch *mSteps = nullptr;
    QSplitter *mSplitter = nullptr;
    PlayerView *mPlayer = nullptr;
    TimelineView *mTimeline = nullptr;
    TransportBar *mTransport = nullptr;
    bool mWasPlaying = false; // before a scrub
};

} // namespace ductus
