// Swapchains: textures of the program's own context.
#include "support/xr_runtime/calls.h"

namespace ductus::xr {

namespace {

constexpr int imageCount = 3;

XrResult withSwapchain(const char *name, XrSwapchain swapchain,
                       const std::function<XrResult(Runtime &, SwapchainObject &)> &body)
{
    return call(name, [&](Runtime &r) {
        const auto found = r.swapchains.find(number(swapchain));
        return found == r.swapchains.end() ? XR_ERROR_HANDLE_INVALID : body(r, found->second);
    });
}

bool isDepth(std::int64_t format)
{
    return format == 0x8CAC || format == 0x81A5 || format == 0x88F0 || format == 0x8CAD;
}

} // namespace

XrResult XRAPI_CALL enumerateSwapchainFormats(XrSession session, std::uint32_t capacity, std::uint32_t *count,
                                              std::int64_t *formats)
{
    return sessionCall("xrEnumerateSwapchainFormats", session, [&](Runtime &r, SessionObject &) {
        const std::vector<std::int64_t> &offered = r.script.scene().formats;
        return enumerate(offered.size(), capacity, count, formats,
                         [&](std::int64_t &format, std::size_t i) { format = offered[i]; });
    });
}

XrResult XRAPI_CALL createSwapchain(XrSession session, const XrSwapchainCreateInfo *info,
                                    XrSwapchain *swapchain)
{
    return sessionCall("xrCreateSwapchain", session, [&](Runtime &r, SessionObject &) {
        if (info->type != XR_TYPE_SWAPCHAIN_CREATE_INFO || info->width == 0 || info->height == 0 ||
            info->width > 4096 || info->height > 4096 || info->faceCount != 1 || info->mipCount != 1)
            return XR_ERROR_VALIDATION_FAILURE;
        if (info->arraySize != 1 || info->sampleCount != 1)
            return XR_ERROR_FEATURE_UNSUPPORTED;
        const std::vector<std::int64_t> &offered = r.script.scene().formats;
        if (std::ranges::find(offered, info->format) == offered.end())
            return XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED;
        SwapchainObject made;
        made.width = int(info->width);
        made.height = int(info->height);
        made.format = info->format;
        made.textures.resize(imageCount);
        glCreateTextures(GL_TEXTURE_2D, imageCount, made.textures.data());
        for (const GLuint texture : made.textures)
            glTextureStorage2D(texture, 1, GLenum(info->format), made.width, made.height);
        const std::uint64_t name = ++r.lastHandle;
        r.recorder.line("swapchain " + std::to_string(info->format) + " " + std::to_string(info->width) +
                        " " + std::to_string(info->height) + (isDepth(info->format) ? " depth" : ""));
        r.swapchains[name] = std::move(made);
        *swapchain = handle<XrSwapchain>(name);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL destroySwapchain(XrSwapchain swapchain)
{
    return withSwapchain("xrDestroySwapchain", swapchain, [&](Runtime &r, SwapchainObject &s) {
        if (glXGetCurrentContext())
            glDeleteTextures(imageCount, s.textures.data());
        r.swapchains.erase(number(swapchain));
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL enumerateSwapchainImages(XrSwapchain swapchain, std::uint32_t capacity,
                                             std::uint32_t *count, XrSwapchainImageBaseHeader *images)
{
    return withSwapchain("xrEnumerateSwapchainImages", swapchain, [&](Runtime &, SwapchainObject &s) {
        auto *list = reinterpret_cast<XrSwapchainImageOpenGLKHR *>(images);
        for (std::uint32_t i = 0; list && i < capacity; ++i)
            if (list[i].type != XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR)
                return XR_ERROR_VALIDATION_FAILURE;
        return enumerate(s.textures.size(), capacity, count, list,
                         [&](XrSwapchainImageOpenGLKHR &to, std::size_t i) { to.image = s.textures[i]; });
    });
}

XrResult XRAPI_CALL acquireSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageAcquireInfo *,
                                          std::uint32_t *index)
{
    return withSwapchain("xrAcquireSwapchainImage", swapchain, [&](Runtime &, SwapchainObject &s) {
        if (s.acquired >= 0)
            return XR_ERROR_CALL_ORDER_INVALID;
        s.acquired = s.next;
        s.next = (s.next + 1) % imageCount;
        s.waited = false;
        *index = std::uint32_t(s.acquired);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL waitSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageWaitInfo *)
{
    return withSwapchain("xrWaitSwapchainImage", swapchain, [&](Runtime &, SwapchainObject &s) {
        if (s.acquired < 0 || s.waited)
            return XR_ERROR_CALL_ORDER_INVALID;
        s.waited = true;
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL releaseSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageReleaseInfo *)
{
    return withSwapchain("xrReleaseSwapchainImage", swapchain, [&](Runtime &, SwapchainObject &s) {
        if (s.acquired < 0 || !s.waited)
            return XR_ERROR_CALL_ORDER_INVALID;
        s.released = s.acquired;
        s.acquired = -1;
        s.waited = false;
        return XR_SUCCESS;
    });
}

} // namespace ductus::xr
