// Instance, system, events.
#include "support/xr_runtime/calls.h"

#include <openxr/openxr_reflection.h>

#include <cstdio>
#include <cstring>

namespace ductus::xr {

namespace {

constexpr XrSystemId systemId = 1;

void write(char *to, std::size_t room, const char *text)
{
    std::snprintf(to, room, "%s", text);
}

} // namespace

XrResult XRAPI_CALL enumerateInstanceExtensionProperties(const char *layer, std::uint32_t capacity,
                                                         std::uint32_t *count,
                                                         XrExtensionProperties *properties)
{
    return call("xrEnumerateInstanceExtensionProperties", [&](Runtime &r) {
        if (layer)
            return XR_ERROR_API_LAYER_NOT_PRESENT;
        if (!r.hasInstance)
            r.reload();
        return enumerate(r.script.scene().hasOpenGl ? 1 : 0, capacity, count, properties,
                         [](XrExtensionProperties &to, std::size_t) {
                             write(to.extensionName, sizeof to.extensionName,
                                   XR_KHR_OPENGL_ENABLE_EXTENSION_NAME);
                             to.extensionVersion = XR_KHR_opengl_enable_SPEC_VERSION;
                         });
    });
}

XrResult XRAPI_CALL createInstance(const XrInstanceCreateInfo *info, XrInstance *instance)
{
    return call("xrCreateInstance", [&](Runtime &r) {
        if (!info || !instance || info->type != XR_TYPE_INSTANCE_CREATE_INFO ||
            info->applicationInfo.applicationName[0] == '\0')
            return XR_ERROR_VALIDATION_FAILURE;
        if (r.hasInstance)
            return XR_ERROR_LIMIT_REACHED;
        if (XR_VERSION_MAJOR(info->applicationInfo.apiVersion) != 1)
            return XR_ERROR_API_VERSION_UNSUPPORTED;
        for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i)
            if (std::strcmp(info->enabledExtensionNames[i], XR_KHR_OPENGL_ENABLE_EXTENSION_NAME) != 0 ||
                !r.script.scene().hasOpenGl)
                return XR_ERROR_EXTENSION_NOT_PRESENT;
        r.hasInstance = true;
        r.step();
        *instance = handle<XrInstance>(++r.lastHandle);
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL destroyInstance(XrInstance)
{
    return call("xrDestroyInstance", [&](Runtime &r) {
        r.destroyAll();
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL getInstanceProperties(XrInstance, XrInstanceProperties *properties)
{
    return call("xrGetInstanceProperties", [&](Runtime &) {
        if (!properties || properties->type != XR_TYPE_INSTANCE_PROPERTIES)
            return XR_ERROR_VALIDATION_FAILURE;
        properties->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
        write(properties->runtimeName, sizeof properties->runtimeName, "Ductus simulated headset");
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL pollEvent(XrInstance, XrEventDataBuffer *event)
{
    return call("xrPollEvent", [&](Runtime &r) {
        if (!event || event->type != XR_TYPE_EVENT_DATA_BUFFER)
            return XR_ERROR_VALIDATION_FAILURE;
        // While no frames are asked for the script goes on here.
        if (!r.session || !r.session->isRunning) {
            r.script.advance(r.session ? r.session->frame : 0);
            r.step();
        }
        if (r.events.empty())
            return XR_EVENT_UNAVAILABLE;
        *event = r.events.front();
        r.events.pop_front();
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL resultToString(XrInstance, XrResult value, char buffer[XR_MAX_RESULT_STRING_SIZE])
{
    return call("xrResultToString", [&](Runtime &) {
        switch (value) {
#define NAME(word, number)                                                                                   \
    case word:                                                                                               \
        write(buffer, XR_MAX_RESULT_STRING_SIZE, #word);                                                     \
        break;
            XR_LIST_ENUM_XrResult(NAME)
#undef NAME
                default : std::snprintf(buffer, XR_MAX_RESULT_STRING_SIZE, "XR_UNKNOWN_%s_%d",
                                        value < 0 ? "FAILURE" : "SUCCESS", int(value));
        }
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL structureTypeToString(XrInstance, XrStructureType value,
                                          char buffer[XR_MAX_STRUCTURE_NAME_SIZE])
{
    return call("xrStructureTypeToString", [&](Runtime &) {
        switch (value) {
#define NAME(word, number)                                                                                   \
    case word:                                                                                               \
        write(buffer, XR_MAX_STRUCTURE_NAME_SIZE, #word);                                                    \
        break;
            XR_LIST_ENUM_XrStructureType(NAME)
#undef NAME
                default : std::snprintf(buffer, XR_MAX_STRUCTURE_NAME_SIZE, "XR_UNKNOWN_STRUCTURE_TYPE_%d",
                                        int(value));
        }
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL getSystem(XrInstance, const XrSystemGetInfo *info, XrSystemId *system)
{
    return call("xrGetSystem", [&](Runtime &r) {
        if (!info || !system || info->type != XR_TYPE_SYSTEM_GET_INFO)
            return XR_ERROR_VALIDATION_FAILURE;
        if (info->formFactor != XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY)
            return XR_ERROR_FORM_FACTOR_UNSUPPORTED;
        if (!r.script.scene().hasHeadset)
            return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
        *system = systemId;
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL getSystemProperties(XrInstance, XrSystemId system, XrSystemProperties *properties)
{
    return call("xrGetSystemProperties", [&](Runtime &) {
        if (system != systemId)
            return XR_ERROR_SYSTEM_INVALID;
        properties->systemId = systemId;
        properties->vendorId = 0;
        write(properties->systemName, sizeof properties->systemName, "Simulated headset");
        properties->graphicsProperties = {4096, 4096, 16};
        properties->trackingProperties = {XR_TRUE, XR_TRUE};
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL enumerateEnvironmentBlendModes(XrInstance, XrSystemId system,
                                                   XrViewConfigurationType configuration,
                                                   std::uint32_t capacity, std::uint32_t *count,
                                                   XrEnvironmentBlendMode *modes)
{
    return call("xrEnumerateEnvironmentBlendModes", [&](Runtime &) {
        if (system != systemId)
            return XR_ERROR_SYSTEM_INVALID;
        if (configuration != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
            return XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED;
        return enumerate(1, capacity, count, modes, [](XrEnvironmentBlendMode &mode, std::size_t) {
            mode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
        });
    });
}

XrResult XRAPI_CALL enumerateViewConfigurations(XrInstance, XrSystemId, std::uint32_t capacity,
                                                std::uint32_t *count, XrViewConfigurationType *types)
{
    return call("xrEnumerateViewConfigurations", [&](Runtime &) {
        return enumerate(1, capacity, count, types, [](XrViewConfigurationType &type, std::size_t) {
            type = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
        });
    });
}

XrResult XRAPI_CALL getViewConfigurationProperties(XrInstance, XrSystemId, XrViewConfigurationType type,
                                                   XrViewConfigurationProperties *properties)
{
    return call("xrGetViewConfigurationProperties", [&](Runtime &) {
        if (type != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
            return XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED;
        properties->viewConfigurationType = type;
        properties->fovMutable = XR_FALSE;
        return XR_SUCCESS;
    });
}

XrResult XRAPI_CALL enumerateViewConfigurationViews(XrInstance, XrSystemId, XrViewConfigurationType type,
                                                    std::uint32_t capacity, std::uint32_t *count,
                                                    XrViewConfigurationView *views)
{
    return call("xrEnumerateViewConfigurationViews", [&](Runtime &r) {
        if (type != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
            return XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED;
        for (std::uint32_t i = 0; i < capacity && views; ++i)
            if (views[i].type != XR_TYPE_VIEW_CONFIGURATION_VIEW)
                return XR_ERROR_VALIDATION_FAILURE;
        const Scene &scene = r.script.scene();
        return enumerate(viewCount, capacity, count, views, [&](XrViewConfigurationView &view, std::size_t) {
            view.recommendedImageRectWidth = std::uint32_t(scene.width);
            view.recommendedImageRectHeight = std::uint32_t(scene.height);
            view.maxImageRectWidth = view.maxImageRectHeight = 4096;
            view.recommendedSwapchainSampleCount = 1;
            view.maxSwapchainSampleCount = 1;
        });
    });
}

XrResult XRAPI_CALL getOpenGlGraphicsRequirements(XrInstance, XrSystemId system,
                                                  XrGraphicsRequirementsOpenGLKHR *requirements)
{
    return call("xrGetOpenGLGraphicsRequirementsKHR", [&](Runtime &r) {
        if (system != systemId)
            return XR_ERROR_SYSTEM_INVALID;
        requirements->minApiVersionSupported = XR_MAKE_VERSION(4, 3, 0);
        requirements->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
        r.requirementsAsked = true;
        return XR_SUCCESS;
    });
}

} // namespace ductus::xr
