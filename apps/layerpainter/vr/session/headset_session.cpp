#include "layerpainter/vr/session/headset_session.h"

#include "layerpainter/vr/session/glx_binding.h"
#include "layerpainter/vr/session/xr_words.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr const char *attempted = "Painting in VR";
constexpr float eyeHeight = 1.6f; // metres, of who stands where the room's floor is not known

constexpr XrPosef here{{0, 0, 0, 1}, {0, 0, 0}};

} // namespace

Result<std::unique_ptr<HeadsetSession>> HeadsetSession::create(const HeadsetRuntime &runtime)
{
    Result<XrSession> made = createGlxSession(runtime);
    if (!made)
        return made.error();
    std::unique_ptr<HeadsetSession> session(new HeadsetSession(runtime));
    session->mSession = *made;
    if (Result<void> room = session->createRoom(); !room)
        return room.error();
    std::uint32_t count = 0;
    XrEnvironmentBlendMode modes[8] = {};
    const XrResult got = xrEnumerateEnvironmentBlendModes(
        runtime.instance(), runtime.system(), XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 8, &count, modes);
    if (XR_FAILED(got))
        return xrError("Entering VR", "xrEnumerateEnvironmentBlendModes", got);
    // Opaque where there is the choice; headsets one sees through have none.
    if (count > 0 && std::find(modes, modes + count, XR_ENVIRONMENT_BLEND_MODE_OPAQUE) == modes + count)
        session->mBlendMode = modes[0];
    return session;
}

HeadsetSession::~HeadsetSession()
{
    if (mRoom != XR_NULL_HANDLE)
        xrDestroySpace(mRoom);
    if (mSession != XR_NULL_HANDLE)
        xrDestroySession(mSession);
}

Result<void> HeadsetSession::createRoom()
{
    std::uint32_t count = 0;
    XrReferenceSpaceType types[16] = {};
    XrResult result = xrEnumerateReferenceSpaces(mSession, 16, &count, types);
    if (XR_FAILED(result))
        return xrError("Entering VR", "xrEnumerateReferenceSpaces", result);
    auto info = xrStruct<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    info.poseInReferenceSpace = here;
    info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_STAGE;
    if (std::find(types, types + count, info.referenceSpaceType) == types + count) {
        info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
        info.poseInReferenceSpace.position.y = -eyeHeight; // where the floor should be
    }
    result = xrCreateReferenceSpace(mSession, &info, &mRoom);
    return checkXr("Entering VR", "xrCreateReferenceSpace", result);
}

Result<SessionNews> HeadsetSession::takeEvents()
{
    SessionNews news;
    for (;;) {
        Result<std::optional<XrEventDataBuffer>> event = mRuntime.nextEvent();
        if (!event)
            return event.error();
        if (!*event)
            return news;
        const auto *any = reinterpret_cast<const XrEventDataBaseHeader *>(&**event);
        if (any->type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING) {
            news.lost = true;
        } else if (any->type == XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED) {
            news.profileChanged = true;
        } else if (any->type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING) {
            news.spaceMoved = true;
        } else if (any->type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) {
            const auto *change = reinterpret_cast<const XrEventDataSessionStateChanged *>(any);
            if (change->session != mSession)
                continue; // of one before
            if (Result<void> done = changeState(change->state, news); !done)
                return done.error();
        }
    }
}

Result<void> HeadsetSession::changeState(XrSessionState state, SessionNews &news)
{
    news.focusLost |= hasFocus() && state != XR_SESSION_STATE_FOCUSED;
    mState = state;
    switch (state) {
    case XR_SESSION_STATE_READY: {
        auto info = xrStruct<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
        info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
        const XrResult begun = xrBeginSession(mSession, &info);
        mIsRunning = XR_SUCCEEDED(begun);
        return checkXr(attempted, "xrBeginSession", begun);
    }
    case XR_SESSION_STATE_STOPPING:
        mIsRunning = false;
        news.stopped = true;
        return checkXr(attempted, "xrEndSession", xrEndSession(mSession));
    case XR_SESSION_STATE_EXITING:
        news.finished = true;
        return {};
    case XR_SESSION_STATE_LOSS_PENDING:
        mIsRunning = false;
        news.lost = true;
        return {};
    default:
        return {};
    }
}

Result<FrameTime> HeadsetSession::wait()
{
    auto info = xrStruct<XrFrameWaitInfo>(XR_TYPE_FRAME_WAIT_INFO);
    auto state = xrStruct<XrFrameState>(XR_TYPE_FRAME_STATE);
    const XrResult waited = xrWaitFrame(mSession, &info, &state);
    if (XR_FAILED(waited))
        return xrError(attempted, "xrWaitFrame", waited);
    return FrameTime{state.predictedDisplayTime, state.shouldRender == XR_TRUE};
}

Result<void> HeadsetSession::begin()
{
    auto info = xrStruct<XrFrameBeginInfo>(XR_TYPE_FRAME_BEGIN_INFO);
    return checkXr(attempted, "xrBeginFrame", xrBeginFrame(mSession, &info));
}

Result<std::vector<EyeView>> HeadsetSession::views(XrTime time)
{
    auto info = xrStruct<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
    info.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    info.displayTime = time;
    info.space = mRoom;
    auto state = xrStruct<XrViewState>(XR_TYPE_VIEW_STATE);
    XrView views[2] = {xrStruct<XrView>(XR_TYPE_VIEW), xrStruct<XrView>(XR_TYPE_VIEW)};
    std::uint32_t count = 0;
    const XrResult located = xrLocateViews(mSession, &info, &state, 2, &count, views);
    if (XR_FAILED(located))
        return xrError(attempted, "xrLocateViews", located);
    constexpr XrViewStateFlags needed =
        XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    std::vector<EyeView> eyes;
    if ((state.viewStateFlags & needed) == needed)
        for (std::uint32_t i = 0; i < count; ++i)
            eyes.push_back({views[i].pose, views[i].fov});
    return eyes;
}

Result<void> HeadsetSession::end(XrTime time, const XrCompositionLayerProjection *layer)
{
    auto info = xrStruct<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    info.displayTime = time;
    info.environmentBlendMode = mBlendMode;
    const auto *base = reinterpret_cast<const XrCompositionLayerBaseHeader *>(layer);
    info.layerCount = layer ? 1 : 0;
    info.layers = layer ? &base : nullptr;
    return checkXr(attempted, "xrEndFrame", xrEndFrame(mSession, &info));
}

Result<void> HeadsetSession::requestExit()
{
    return checkXr("Leaving VR", "xrRequestExitSession", xrRequestExitSession(mSession));
}

} // namespace ductus
