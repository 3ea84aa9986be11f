// The session's life, and spaces.
#include "support/xr_runtime/calls.h"

namespace ductus::xr {

XrResult XRAPI_CALL createSession(XrInstance, const XrSessionCreateInfo *info, XrSession *session)
{
    return call("xrCreateSession", [&](Runtime &r) {
        if (!info || !session || info->type != XR_TYPE_SESSION_CREATE_INFO)
            return XR_ERROR_VALIDATION_FAILURE;
        if (info->systemId != 1)
            return XR_ERROR_SYSTEM_INVALID;
        if (!r.requirementsAsked)
            return XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING;
        const auto *binding = static_cast<const XrGraphicsBindingOpenGLXlibKHR *>(info->next);
        if (!binding || binding->type != XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR || !binding->xDisplay ||
            !binding->glxContext || !binding->glxFBConfig || !binding->glxDrawable)
            return XR_ERROR_GRAPHICS_DEVICE_INVALID;
        int config = 0, configOfContext = 0;
        glXGetFBConfigAttrib(binding->xDisplay, binding->glxFBConfig, GLX_FBCONFIG_ID, &config);
        glXQueryContext(binding->xDisplay, binding->glxContext, GLX_FBCONFIG_ID, &configOfContext);
        if (config != configOfContext || glXGetCurrentContext() != binding->glxContext)
            return XR_ERROR_GRAPHICS_DEVICE_INVALID;
        if (r.session)
            return XR_ERROR_LIMIT_REACHED;
        r.session = std::make_unique<SessionObject>();
        r.sessionHandle = ++r.lastHandle;
        *session = handle<XrSession>(r.sessionHandle);
        r.setState(XR_SESSION_STATE_IDLE);
        r.setState(XR_SESSION_STATE_READY);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL destroySession(XrSession session)
{
    return call("xrDestroySession", [&](Runtime &r) {
        if (!r.session || number(session) != r.sessionHandle)
            return XR_ERROR_HANDLE_INVALID;
        r.recorder.line("destroyed session");
        r.session.reset();
        r.spaces.clear();
        r.swapchains.clear(); // the textures went with the context, or go with it
        for (auto &[name, set] : r.actionSets)
            set.isAttached = false;
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL beginSession(XrSession session, const XrSessionBeginInfo *info)
{
    return sessionCall("xrBeginSession", session, [&](Runtime &, SessionObject &s) {
        if (s.isRunning)
            return XR_ERROR_SESSION_RUNNING;
        if (s.state != XR_SESSION_STATE_READY)
            return XR_ERROR_SESSION_NOT_READY;
        if (info->primaryViewConfigurationType != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
            return XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED;
        s.isRunning = true;
        s.goal = XR_SESSION_STATE_FOCUSED;
        s.isWaited = s.isBegun = false;
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL endSession(XrSession session)
{
    return sessionCall("xrEndSession", session, [&](Runtime &r, SessionObject &s) {
        if (!s.isRunning)
            return XR_ERROR_SESSION_NOT_RUNNING;
        if (s.state != XR_SESSION_STATE_STOPPING)
            return XR_ERROR_SESSION_NOT_STOPPING;
        s.isRunning = false;
        r.setState(XR_SESSION_STATE_IDLE);
        if (s.isLeaving)
            r.setState(XR_SESSION_STATE_EXITING);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL requestExitSession(XrSession session)
{
    return sessionCall("xrRequestExitSession", session, [&](Runtime &, SessionObject &s) {
        if (!s.isRunning)
            return XR_ERROR_SESSION_NOT_RUNNING;
        s.goal = XR_SESSION_STATE_STOPPING;
        s.isLeaving = true;
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL enumerateReferenceSpaces(XrSession session, std::uint32_t capacity, std::uint32_t *count,
                                             XrReferenceSpaceType *types)
{
    return sessionCall("xrEnumerateReferenceSpaces", session, [&](Runtime &r, SessionObject &) {
        static constexpr XrReferenceSpaceType all[] = {
            XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL, XR_REFERENCE_SPACE_TYPE_STAGE};
        return enumerate(r.script.scene().hasStage ? 3 : 2, capacity, count, types,
                         [](XrReferenceSpaceType &type, std::size_t i) { type = all[i]; });
    });
}

XrResult XRAPI_CALL createReferenceSpace(XrSession session, const XrReferenceSpaceCreateInfo *info,
                                         XrSpace *space)
{
    return sessionCall("xrCreateReferenceSpace", session, [&](Runtime &r, SessionObject &) {
        const auto offset = isometryOf(info->poseInReferenceSpace);
        if (!offset)
            return XR_ERROR_POSE_INVALID;
        const XrReferenceSpaceType type = info->referenceSpaceType;
        const bool isThere = type == XR_REFERENCE_SPACE_TYPE_VIEW || type == XR_REFERENCE_SPACE_TYPE_LOCAL ||
                             (type == XR_REFERENCE_SPACE_TYPE_STAGE && r.script.scene().hasStage);
        if (!isThere)
            return XR_ERROR_REFERENCE_SPACE_UNSUPPORTED;
        const std::uint64_t made = ++r.lastHandle;
        r.spaces[made] = {type, 0, 0, *offset};
        *space = handle<XrSpace>(made);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL getReferenceSpaceBoundsRect(XrSession session, XrReferenceSpaceType, XrExtent2Df *bounds)
{
    return sessionCall("xrGetReferenceSpaceBoundsRect", session, [&](Runtime &, SessionObject &) {
        *bounds = {3, 3};
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL createActionSpace(XrSession session, const XrActionSpaceCreateInfo *info, XrSpace *space)
{
    return sessionCall("xrCreateActionSpace", session, [&](Runtime &r, SessionObject &) {
        const auto action = r.actions.find(number(info->action));
        if (action == r.actions.end())
            return XR_ERROR_HANDLE_INVALID;
        if (action->second.type != XR_ACTION_TYPE_POSE_INPUT)
            return XR_ERROR_ACTION_TYPE_MISMATCH;
        const auto offset = isometryOf(info->poseInActionSpace);
        if (!offset)
            return XR_ERROR_POSE_INVALID;
        const std::string *path = r.textOf(info->subactionPath);
        if (!path || std::ranges::find(action->second.subactions, info->subactionPath) ==
                         action->second.subactions.end())
            return XR_ERROR_PATH_UNSUPPORTED;
        const std::uint64_t made = ++r.lastHandle;
        r.spaces[made] = {XR_REFERENCE_SPACE_TYPE_STAGE, number(info->action),
                          path->ends_with("right") ? 1 : 0, *offset};
        *space = handle<XrSpace>(made);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL locateSpace(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation *location)
{
    return call("xrLocateSpace", [&](Runtime &r) {
        const auto of = r.spaces.find(number(space)), in = r.spaces.find(number(base));
        if (of == r.spaces.end() || in == r.spaces.end())
            return XR_ERROR_HANDLE_INVALID;
        if (time <= 0)
            return XR_ERROR_TIME_INVALID;
        if (location->type != XR_TYPE_SPACE_LOCATION)
            return XR_ERROR_VALIDATION_FAILURE;
        location->locationFlags = 0;
        // Poses of hands need input: without focus there is none.
        const bool isInput = of->second.action != 0;
        if (isInput && (!r.session || r.session->state != XR_SESSION_STATE_FOCUSED))
            return XR_SUCCESS;
        const auto place = r.placeOf(of->second), frame = r.placeOf(in->second);
        if (place && frame) {
            location->pose = poseOf(frame->inverse() * *place);
            location->locationFlags = 0xF; // valid and tracked, both parts
        }
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL destroySpace(XrSpace space)
{
    return call("xrDestroySpace", [&](Runtime &r) {
        return r.spaces.erase(number(space)) ? XR_SUCCESS : XR_ERROR_HANDLE_INVALID;
    });
}

} // namespace ductus::xr
