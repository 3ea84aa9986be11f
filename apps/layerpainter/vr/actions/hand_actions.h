// HandActions: the hands' poses and buttons out of OpenXR, and what is felt into it.
#pragma once

#include "base/result.h"
#include "layerpainter/vr/hands/hand_input.h"

#include <openxr/openxr.h>

#include <memory>

namespace ductus {

class HeadsetRuntime;
class HeadsetSession;

class HandActions
{
public:
    /// Suggests bindings for controllerProfiles(); once a session.
    static Result<std::unique_ptr<HandActions>> create(const HeadsetRuntime &runtime,
                                                       const HeadsetSession &session);
    ~HandActions();
    HandActions(const HandActions &) = delete;
    HandActions &operator=(const HandActions &) = delete;

    /// The hands at the moment \a time; untracked while the session has no focus.
    Result<void> read(XrTime time, HandsInput &input);

    /// A short tick. \a strength 0..1.
    void tick(Hand hand, double strength, double seconds);

    /// The controllers in use: "/interaction_profiles/valve/index_controller"; empty: none.
    std::string profile(Hand hand) const;

private:
    HandActions(const HeadsetRuntime &runtime, const HeadsetSession &session)
        : mRuntime(runtime), mSession(session)
    {
    }
    Result<void> createActions();
    Result<void> suggestBindings();
    Result<void> createSpaces();
    Result<void> readHand(int hand, XrTime time, HandInput &input);

    static constexpr int actionCount = 8; // of HandAction
    const HeadsetRuntime &mRuntime;
    const HeadsetSession &mSession;
    XrActionSet mSet = XR_NULL_HANDLE;
    XrAction mActions[actionCount] = {};
    XrPath mHands[2] = {};
    XrSpace mGrips[2] = {}, mAims[2] = {};
};

} // namespace ductus
