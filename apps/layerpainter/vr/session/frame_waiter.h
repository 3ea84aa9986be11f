// FrameWaiter: waits for the headset's next frame on a thread of its own, so that the window never does.
#pragma once

#include "layerpainter/vr/session/headset_session.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace ductus {

class FrameWaiter
{
public:
    /// \a arrived is called on the waiter's thread, once for every request().
    FrameWaiter(HeadsetSession &session, std::function<void(Result<FrameTime>)> arrived);
    /// Waits for a request that is under way.
    ~FrameWaiter();

    /// Waits for one frame; the one before must have arrived.
    void request();

private:
    void run();

    HeadsetSession &mSession;
    std::function<void(Result<FrameTime>)> mArrived;
    std::mutex mMutex;
    std::condition_variable mWake;
    bool mIsRequested = false, mIsEnding = false;
    std::thread mThread; // last: begins when all else is there
};

} // namespace ductus
