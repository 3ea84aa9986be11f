// VrMode: the window's painting in a headset: from start() until ended(). The window stays usable, shows what
// the left eye sees, and never waits for the headset; the headset never waits for a file or a job.
#pragma once

#include "layerpainter/vr/actions/hand_actions.h"
#include "layerpainter/vr/draw/eye_painter.h"
#include "layerpainter/vr/mode/hand_tools.h"
#include "layerpainter/vr/mode/room_marks.h"
#include "layerpainter/vr/mode/room_panels.h"
#include "layerpainter/vr/session/frame_waiter.h"

#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>

namespace ductus {

class VrMode : public QObject
{
    Q_OBJECT
public:
    explicit VrMode(PainterWindow &window, QObject *parent = nullptr);
    ~VrMode() override;

    /// Unsupported with what is missing; the window goes on as before.
    Result<void> start();
    /// Ends by and by; ended() follows. Nothing is lost: a stroke that is being painted is finished.
    void stop();
    bool isActive() const { return mSession != nullptr; }

    void setLeftHanded(bool leftHanded);
    bool isLeftHanded() const { return mTools.paintingHand() == Hand::Left; }

    XrSessionState state() const { return mSession ? mSession->state() : XR_SESSION_STATE_UNKNOWN; }
    HandTools &tools() { return mTools; }
    RoomPanels &panels() { return *mPanels; } // only while active
    int frameCount() const { return mFrameCount; }
    /// Of what the last frame took here, and the longest since it was asked for: between two frames.
    double lastFrameMilliseconds() const { return mLastFrameMilliseconds; }
    double takeLongestGapMilliseconds();

signals:
    /// VR is over; \a error says why, or is empty if it was asked for.
    void ended(const QString &error);
    void frameDone();

private:
    Result<void> createParts();
    Result<void> makeContext();
    void placeFirst();
    void onFrame(Result<FrameTime> time);
    Result<void> drawFrame(const FrameTime &time);
    void readHands(const FrameTime &time, const std::vector<EyeView> &eyes);
    void point(const std::vector<HandCommand> &commands);
    std::optional<PanelHit> pointed() const;
    void takeEvents();
    void goOn();
    void end(const std::optional<Error> &error);
    void release();
    void drawMirror(unsigned framebuffer, const QSize &size);
    void tick(Hand hand, double strength, double seconds);

    PainterWindow &mWindow;
    HandTools mTools;
    HandCommands mCommands;
    HandsInput mInput;
    std::unique_ptr<QOpenGLContext> mContext;
    std::unique_ptr<QOffscreenSurface> mSurface;
    std::unique_ptr<HeadsetRuntime> mRuntime; // then what hangs on it, in this order
    std::unique_ptr<HeadsetSession> mSession;
    std::unique_ptr<HandActions> mActions;
    std::unique_ptr<EyePainter> mPainter;
    std::unique_ptr<RoomPanels> mPanels;
    std::unique_ptr<FrameWaiter> mWaiter; // last: its thread uses the session
    OverlayShapes mShapes;
    StrokeMarks mMarks;
    std::optional<PanelHit> mPointed;
    int mPressed = -1;       // panel
    bool mIsTouched = false; // by a finger's tip, not by the trigger
    bool mIsWaiting = false;
    bool mIsInFrame = false;
    bool mWasFocused = false;
    XrTime mLastDisplay = 0;
    QTimer mIdle;     // looks for events while no frames are wanted
    QTimer mPatience; // the end was asked for and does not come
    QTimer mMirrorPace;
    QElapsedTimer mGapClock;
    double mLongestGap = 0;
    double mLastFrameMilliseconds = 0;
    int mFrameCount = 0;
    quint64 mRun = 0; // tells frames of an ended session from those of the next
};

} // namespace ductus
