#include "layerpainter/vr/session/frame_waiter.h"

namespace ductus {

FrameWaiter::FrameWaiter(HeadsetSession &session, std::function<void(Result<FrameTime>)> arrived)
    : mSession(session), mArrived(std::move(arrived)), mThread([this] { run(); })
{
}

FrameWaiter::~FrameWaiter()
{
    {
        const std::lock_guard lock(mMutex);
        mIsEnding = true;
    }
    mWake.notify_one();
    mThread.join();
}

void FrameWaiter::request()
{
    {
        const std::lock_guard lock(mMutex);
        mIsRequested = true;
    }
    mWake.notify_one();
}

void FrameWaiter::run()
{
    for (;;) {
        {
            std::unique_lock lock(mMutex);
            mWake.wait(lock, [this] { return mIsRequested || mIsEnding; });
            if (mIsEnding)
                return;
            mIsRequested = false;
        }
        mArrived(mSession.wait());
    }
}

} // namespace ductus
