#include "layerpainter/vr/session/headset_runtime.h"

#include "layerpainter/vr/session/xr_words.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <vector>

namespace ductus {

namespace {

constexpr const char *attempted = "Entering VR";
constexpr const char *openGl = "XR_KHR_opengl_enable";

Result<void> checkOpenGl()
{
    std::uint32_t count = 0;
    XrResult result = xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr);
    if (XR_FAILED(result))
        return xrError(attempted, "xrEnumerateInstanceExtensionProperties", result);
    std::vector<XrExtensionProperties> extensions(
        count, xrStruct<XrExtensionProperties>(XR_TYPE_EXTENSION_PROPERTIES));
    result = count == 0 ? XR_SUCCESS
                        : xrEnumerateInstanceExtensionProperties(nullptr, count, &count, extensions.data());
    if (XR_FAILED(result))
        return xrError(attempted, "xrEnumerateInstanceExtensionProperties", result);
    if (std::ranges::none_of(extensions, [](const XrExtensionProperties &extension) {
            return std::strcmp(extension.extensionName, openGl) == 0;
        }))
        return xrError(attempted, "xrCreateInstance", XR_ERROR_EXTENSION_NOT_PRESENT);
    return {};
}

} // namespace

Result<std::unique_ptr<HeadsetRuntime>> HeadsetRuntime::find()
{
    if (Result<void> fine = checkOpenGl(); !fine)
        return fine.error();
    auto info = xrStruct<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
    std::snprintf(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE, "LayerPainter");
    std::snprintf(info.applicationInfo.engineName, XR_MAX_ENGINE_NAME_SIZE, "Ductus");
    info.applicationInfo.applicationVersion = 1;
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0); // the core alone is asked for
    info.enabledExtensionCount = 1;
    info.enabledExtensionNames = &openGl;
    std::unique_ptr<HeadsetRuntime> runtime(new HeadsetRuntime);
    if (const XrResult made = xrCreateInstance(&info, &runtime->mInstance); XR_FAILED(made)) {
        runtime->mInstance = XR_NULL_HANDLE;
        return xrError(attempted, "xrCreateInstance", made);
    }
    auto properties = xrStruct<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
    if (XR_SUCCEEDED(xrGetInstanceProperties(runtime->mInstance, &properties)))
        runtime->mName = properties.runtimeName;
    auto wanted = xrStruct<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
    wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    if (const XrResult got = xrGetSystem(runtime->mInstance, &wanted, &runtime->mSystem); XR_FAILED(got))
        return xrError(attempted, "xrGetSystem", got);
    return runtime;
}

HeadsetRuntime::~HeadsetRuntime()
{
    if (mInstance != XR_NULL_HANDLE)
        xrDestroyInstance(mInstance);
}

Result<std::optional<XrEventDataBuffer>> HeadsetRuntime::nextEvent() const
{
    auto event = xrStruct<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
    const XrResult got = xrPollEvent(mInstance, &event);
    if (XR_FAILED(got))
        return xrError("Painting in VR", "xrPollEvent", got);
    return got == XR_EVENT_UNAVAILABLE ? std::optional<XrEventDataBuffer>() : std::optional(event);
}

XrPath HeadsetRuntime::path(const std::string &text) const
{
    XrPath path = XR_NULL_PATH;
    xrStringToPath(mInstance, text.c_str(), &path); // ours are well formed
    return path;
}

std::string HeadsetRuntime::text(XrPath path) const
{
    std::uint32_t count = 0;
    if (path == XR_NULL_PATH || XR_FAILED(xrPathToString(mInstance, path, 0, &count, nullptr)) || count == 0)
        return {};
    std::string text(count, '\0');
    if (XR_FAILED(xrPathToString(mInstance, path, count, &count, text.data())))
        return {};
    text.resize(count - 1); // without the closing null
    return text;
}

} // namespace ductus
