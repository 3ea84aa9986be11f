#include "layerpainter/vr/session/eye_images.h"

#include "layerpainter/vr/session/headset_runtime.h"
#include "layerpainter/vr/session/xr_words.h"

#include <epoxy/glx.h>

#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>

namespace ductus {

namespace {

constexpr const char *attempted = "Entering VR";

} // namespace

Result<std::vector<EyeSize>> recommendedSizes(const HeadsetRuntime &runtime)
{
    XrViewConfigurationView views[2] = {xrStruct<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW),
                                        xrStruct<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW)};
    std::uint32_t count = 0;
    const XrResult got = xrEnumerateViewConfigurationViews(
        runtime.instance(), runtime.system(), XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 2, &count, views);
    if (XR_FAILED(got))
        return xrError(attempted, "xrEnumerateViewConfigurationViews", got);
    std::vector<EyeSize> sizes;
    for (std::uint32_t i = 0; i < count; ++i)
        sizes.push_back({int(views[i].recommendedImageRectWidth), int(views[i].recommendedImageRectHeight),
                         std::max(1, int(views[i].recommendedSwapchainSampleCount))});
    return sizes;
}

Result<std::int64_t> chooseFormat(const std::vector<std::int64_t> &offered)
{
    for (const std::int64_t wanted : {GL_SRGB8_ALPHA8, GL_RGBA16F, GL_RGBA16, GL_RGB10_A2, GL_RGBA8})
        if (std::ranges::find(offered, wanted) != offered.end())
            return wanted;
    return Error{ErrorCode::Unsupported, attempted,
                 "the headset software offers no kind of image that OpenGL can draw onto",
                 "Update the headset software", "xrEnumerateSwapchainFormats"};
}

Result<std::int64_t> chooseFormat(XrSession session)
{
    std::uint32_t count = 0;
    XrResult got = xrEnumerateSwapchainFormats(session, 0, &count, nullptr);
    std::vector<std::int64_t> formats(count);
    if (XR_SUCCEEDED(got) && count > 0)
        got = xrEnumerateSwapchainFormats(session, count, &count, formats.data());
    if (XR_FAILED(got))
        return xrError(attempted, "xrEnumerateSwapchainFormats", got);
    return chooseFormat(formats);
}

Result<std::unique_ptr<EyeImages>> EyeImages::create(XrSession session, std::int64_t format,
                                                     const EyeSize &size)
{
    auto info = xrStruct<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
    info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
    info.format = format;
    info.sampleCount = 1; // samples are resolved before: the renderer's own
    info.width = std::uint32_t(size.width);
    info.height = std::uint32_t(size.height);
    info.faceCount = info.arraySize = info.mipCount = 1;
    std::unique_ptr<EyeImages> images(new EyeImages);
    images->mFormat = format;
    images->mSize = size;
    XrResult result = xrCreateSwapchain(session, &info, &images->mSwapchain);
    if (XR_FAILED(result))
        return xrError(attempted, "xrCreateSwapchain", result);
    std::uint32_t count = 0;
    result = xrEnumerateSwapchainImages(images->mSwapchain, 0, &count, nullptr);
    std::vector<XrSwapchainImageOpenGLKHR> list(
        count, xrStruct<XrSwapchainImageOpenGLKHR>(XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR));
    if (XR_SUCCEEDED(result))
        result = xrEnumerateSwapchainImages(images->mSwapchain, count, &count,
                                            reinterpret_cast<XrSwapchainImageBaseHeader *>(list.data()));
    if (XR_FAILED(result))
        return xrError(attempted, "xrEnumerateSwapchainImages", result);
    for (const XrSwapchainImageOpenGLKHR &image : list) {
        GlFramebuffer target = GlFramebuffer::create();
        glBindFramebuffer(GL_FRAMEBUFFER, target.name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.image, 0);
        images->mTargets.push_back(std::move(target));
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return images;
}

EyeImages::~EyeImages()
{
    mTargets.clear();
    if (mSwapchain != XR_NULL_HANDLE)
        xrDestroySwapchain(mSwapchain);
}

bool EyeImages::isLinear() const
{
    return mFormat != GL_SRGB8_ALPHA8;
}

Result<GLuint> EyeImages::acquire()
{
    auto acquireInfo = xrStruct<XrSwapchainImageAcquireInfo>(XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO);
    std::uint32_t index = 0;
    XrResult result = xrAcquireSwapchainImage(mSwapchain, &acquireInfo, &index);
    if (XR_FAILED(result))
        return xrError("Painting in VR", "xrAcquireSwapchainImage", result);
    auto waitInfo = xrStruct<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    waitInfo.timeout = XR_INFINITE_DURATION;
    result = xrWaitSwapchainImage(mSwapchain, &waitInfo);
    if (XR_FAILED(result))
        return xrError("Painting in VR", "xrWaitSwapchainImage", result);
    return mTargets[index].name();
}

Result<void> EyeImages::release()
{
    auto info = xrStruct<XrSwapchainImageReleaseInfo>(XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO);
    return checkXr("Painting in VR", "xrReleaseSwapchainImage", xrReleaseSwapchainImage(mSwapchain, &info));
}

} // namespace ductus
