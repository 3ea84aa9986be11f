// HeadsetSession: pictures to the headset and poses from it, through all states a session has.
//
// One turn of the frame loop: wait() (may be called on a thread of its own), then on the thread of the
// context takeEvents(), begin(), views(), drawing to images, end(). While isRunning() is false only
// takeEvents().
#pragma once

#include "layerpainter/vr/session/headset_runtime.h"

#include <array>
#include <vector>

namespace ductus {

/// An eye at the moment the next frame is seen.
struct EyeView
{
    XrPosef pose; // in the room: metres, floor at y = 0
    XrFovf field; // radians
};

struct FrameTime
{
    XrTime display = 0;
    bool shouldDraw = false;
};

/// What of the session is another since the last look.
struct SessionNews
{
    bool stopped = false;   // the session was ended as asked; it may begin again by itself
    bool finished = false;  // the user or the headset's software wants VR to end
    bool lost = false;      // session or software are gone; destroy and perhaps enter again
    bool focusLost = false; // hands are somewhere else now
    bool profileChanged = false;
    bool spaceMoved = false; // the room was centred anew
};

class HeadsetSession
{
public:
    /// With the OpenGL context that is current; Unsupported where that cannot be handed over.
    static Result<std::unique_ptr<HeadsetSession>> create(const HeadsetRuntime &runtime);
    ~HeadsetSession();
    HeadsetSession(const HeadsetSession &) = delete;
    HeadsetSession &operator=(const HeadsetSession &) = delete;

    XrSession handle() const { return mSession; }
    XrSpace room() const { return mRoom; }
    XrSessionState state() const { return mState; }
    bool isRunning() const { return mIsRunning; }
    bool hasFocus() const { return mState == XR_SESSION_STATE_FOCUSED; }

    /// Answers what happened: begins and ends the session.
    Result<SessionNews> takeEvents();

    Result<FrameTime> wait();
    Result<void> begin();
    /// From the eyes; empty while the head is not tracked.
    Result<std::vector<EyeView>> views(XrTime time);
    /// \a layer null: nothing is shown.
    Result<void> end(XrTime time, const XrCompositionLayerProjection *layer);

    /// Asks for the end: it comes by events.
    Result<void> requestExit();

private:
    explicit HeadsetSession(const HeadsetRuntime &runtime) : mRuntime(runtime) {}
    Result<void> createRoom();
    Result<void> changeState(XrSessionState state, SessionNews &news);

    const HeadsetRuntime &mRuntime;
    XrSession mSession = XR_NULL_HANDLE;
    XrSpace mRoom = XR_NULL_HANDLE;
    XrEnvironmentBlendMode mBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    XrSessionState mState = XR_SESSION_STATE_UNKNOWN;
    bool mIsRunning = false;
};

} // namespace ductus
