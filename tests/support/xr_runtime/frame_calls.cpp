// Frames: waiting, beginning, where the eyes are, what is submitted.
#include "support/xr_runtime/calls.h"

#include <chrono>
#include <cstdio>
#include <thread>

namespace ductus::xr {

namespace {

// Uneven, as those of a real headset's lenses.
constexpr XrFovf fields[viewCount] = {{-0.90f, 0.72f, 0.80f, -0.85f}, {-0.72f, 0.90f, 0.80f, -0.85f}};

std::string text(const char *format, auto... values)
{
    char line[512];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

XrResult checkView(Runtime &r, const XrCompositionLayerProjectionView &view)
{
    if (view.type != XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW)
        return XR_ERROR_VALIDATION_FAILURE;
    if (!isometryOf(view.pose))
        return XR_ERROR_POSE_INVALID;
    const auto chain = r.swapchains.find(number(view.subImage.swapchain));
    if (chain == r.swapchains.end())
        return XR_ERROR_HANDLE_INVALID;
    if (chain->second.released < 0)
        return XR_ERROR_LAYER_INVALID;
    const XrRect2Di &part = view.subImage.imageRect;
    if (part.offset.x < 0 || part.offset.y < 0 || part.extent.width < 1 || part.extent.height < 1 ||
        part.offset.x + part.extent.width > chain->second.width ||
        part.offset.y + part.extent.height > chain->second.height)
        return XR_ERROR_SWAPCHAIN_RECT_INVALID;
    return XR_SUCCESS;
}

void record(Runtime &r, std::int64_t frame, std::uint32_t index, const XrCompositionLayerProjectionView &view)
{
    const XrPosef &p = view.pose;
    r.recorder.line(text("view %lld %u %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g",
                         static_cast<long long>(frame), index, p.position.x, p.position.y, p.position.z,
                         p.orientation.x, p.orientation.y, p.orientation.z, p.orientation.w,
                         view.fov.angleLeft, view.fov.angleRight, view.fov.angleUp, view.fov.angleDown));
    const std::string &folder = r.script.scene().dumpFolder;
    if (!folder.empty())
        dumpImage(r.swapchains[number(view.subImage.swapchain)], view.subImage.imageRect,
                  folder + text("/frame-%lld-view-%u.png", static_cast<long long>(frame), index));
}

} // namespace

XrResult XRAPI_CALL waitFrame(XrSession session, const XrFrameWaitInfo *, XrFrameState *state)
{
    {
        // The next frame may only be waited for when the last one was begun.
        Runtime &r = runtime();
        std::unique_lock lock(r.mutex);
        r.frameBegun.wait(lock, [&] { return !r.session || !r.session->isRunning || !r.session->isWaited; });
    }
    int pace = 0;
    const XrResult result = sessionCall("xrWaitFrame", session, [&](Runtime &r, SessionObject &s) {
        if (!s.isRunning)
            return XR_ERROR_SESSION_NOT_RUNNING;
        if (!state || state->type != XR_TYPE_FRAME_STATE)
            return XR_ERROR_VALIDATION_FAILURE;
        ++s.frame;
        r.now += framePeriod;
        r.script.advance(s.frame);
        r.step();
        if (s.callsLeft > 0)
            --s.callsLeft;
        if (r.instanceCallsLeft > 0)
            --r.instanceCallsLeft;
        for (; r.toldMistakes < r.script.mistakes().size(); ++r.toldMistakes)
            r.recorder.line("mistake " + r.script.mistakes()[r.toldMistakes]);
        s.isWaited = true;
        state->predictedDisplayTime = r.now;
        state->predictedDisplayPeriod = framePeriod;
        state->shouldRender = s.state == XR_SESSION_STATE_VISIBLE || s.state == XR_SESSION_STATE_FOCUSED;
        pace = r.script.scene().paceMilliseconds;
        return XR_SUCCESS;
    });
    if (pace > 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(pace));
    return result;
}

XrResult XRAPI_CALL beginFrame(XrSession session, const XrFrameBeginInfo *)
{
    return sessionCall("xrBeginFrame", session, [&](Runtime &r, SessionObject &s) {
        if (!s.isRunning)
            return XR_ERROR_SESSION_NOT_RUNNING;
        if (!s.isWaited)
            return XR_ERROR_CALL_ORDER_INVALID;
        s.isWaited = false;
        r.frameBegun.notify_all();
        const bool wasBegun = std::exchange(s.isBegun, true);
        return wasBegun ? XR_FRAME_DISCARDED : XR_SUCCESS;
    });
}

XrResult XRAPI_CALL endFrame(XrSession session, const XrFrameEndInfo *info)
{
    return sessionCall("xrEndFrame", session, [&](Runtime &r, SessionObject &s) {
        if (!s.isRunning)
            return XR_ERROR_SESSION_NOT_RUNNING;
        if (!s.isBegun)
            return XR_ERROR_CALL_ORDER_INVALID;
        if (info->displayTime <= 0)
            return XR_ERROR_TIME_INVALID;
        if (info->environmentBlendMode != XR_ENVIRONMENT_BLEND_MODE_OPAQUE)
            return XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED;
        for (std::uint32_t i = 0; i < info->layerCount; ++i) {
            const auto *layer = reinterpret_cast<const XrCompositionLayerProjection *>(info->layers[i]);
            if (!layer || layer->type != XR_TYPE_COMPOSITION_LAYER_PROJECTION ||
                layer->viewCount != viewCount)
                return XR_ERROR_LAYER_INVALID;
            if (!r.spaces.contains(number(layer->space)))
                return XR_ERROR_HANDLE_INVALID;
            for (std::uint32_t v = 0; v < layer->viewCount; ++v)
                if (const XrResult wrong = checkView(r, layer->views[v]); XR_FAILED(wrong))
                    return wrong;
        }
        s.isBegun = false;
        r.recorder.line(text("frame %lld layers %u", static_cast<long long>(s.frame), info->layerCount));
        for (std::uint32_t i = 0; i < info->layerCount; ++i) {
            const auto *layer = reinterpret_cast<const XrCompositionLayerProjection *>(info->layers[i]);
            for (std::uint32_t v = 0; v < layer->viewCount; ++v)
                record(r, s.frame, v, layer->views[v]);
        }
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL locateViews(XrSession session, const XrViewLocateInfo *info, XrViewState *state,
                                std::uint32_t capacity, std::uint32_t *count, XrView *views)
{
    return sessionCall("xrLocateViews", session, [&](Runtime &r, SessionObject &) {
        if (info->viewConfigurationType != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
            return XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED;
        const auto space = r.spaces.find(number(info->space));
        if (space == r.spaces.end())
            return XR_ERROR_HANDLE_INVALID;
        if (info->displayTime <= 0)
            return XR_ERROR_TIME_INVALID;
        const auto frame = r.placeOf(space->second);
        state->viewStateFlags = frame ? 0xF : 0;
        SpaceObject head;
        head.reference = XR_REFERENCE_SPACE_TYPE_VIEW;
        const Eigen::Isometry3d inSpace =
            frame.value_or(Eigen::Isometry3d::Identity()).inverse() * *r.placeOf(head);
        return enumerate(viewCount, capacity, count, views, [&](XrView &view, std::size_t i) {
            Eigen::Isometry3d eye = inSpace;
            eye.translate(Eigen::Vector3d((i == 0 ? -0.5 : 0.5) * eyeDistance, 0, 0));
            view.pose = poseOf(eye);
            view.fov = fields[i];
        });
    });
}

} // namespace ductus::xr
