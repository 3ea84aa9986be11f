#include "support/xr_runtime/calls.h"

#include <unordered_map>

namespace ductus::xr {

PFN_xrVoidFunction functionOf(const std::string &name)
{
    static const auto at = [](auto *function) { return reinterpret_cast<PFN_xrVoidFunction>(function); };
    static const std::unordered_map<std::string, PFN_xrVoidFunction> functions{
        {"xrEnumerateInstanceExtensionProperties", at(&enumerateInstanceExtensionProperties)},
        {"xrCreateInstance", at(&createInstance)},
        {"xrDestroyInstance", at(&destroyInstance)},
        {"xrGetInstanceProperties", at(&getInstanceProperties)},
        {"xrPollEvent", at(&pollEvent)},
        {"xrResultToString", at(&resultToString)},
        {"xrStructureTypeToString", at(&structureTypeToString)},
        {"xrGetSystem", at(&getSystem)},
        {"xrGetSystemProperties", at(&getSystemProperties)},
        {"xrEnumerateEnvironmentBlendModes", at(&enumerateEnvironmentBlendModes)},
        {"xrEnumerateViewConfigurations", at(&enumerateViewConfigurations)},
        {"xrGetViewConfigurationProperties", at(&getViewConfigurationProperties)},
        {"xrEnumerateViewConfigurationViews", at(&enumerateViewConfigurationViews)},
        {"xrGetOpenGLGraphicsRequirementsKHR", at(&getOpenGlGraphicsRequirements)},
        {"xrCreateSession", at(&createSession)},
        {"xrDestroySession", at(&destroySession)},
        {"xrBeginSession", at(&beginSession)},
        {"xrEndSession", at(&endSession)},
        {"xrRequestExitSession", at(&requestExitSession)},
        {"xrEnumerateReferenceSpaces", at(&enumerateReferenceSpaces)},
        {"xrCreateReferenceSpace", at(&createReferenceSpace)},
        {"xrGetReferenceSpaceBoundsRect", at(&getReferenceSpaceBoundsRect)},
        {"xrCreateActionSpace", at(&createActionSpace)},
        {"xrLocateSpace", at(&locateSpace)},
        {"xrDestroySpace", at(&destroySpace)},
        {"xrEnumerateSwapchainFormats", at(&enumerateSwapchainFormats)},
        {"xrCreateSwapchain", at(&createSwapchain)},
        {"xrDestroySwapchain", at(&destroySwapchain)},
        {"xrEnumerateSwapchainImages", at(&enumerateSwapchainImages)},
        {"xrAcquireSwapchainImage", at(&acquireSwapchainImage)},
        {"xrWaitSwapchainImage", at(&waitSwapchainImage)},
        {"xrReleaseSwapchainImage", at(&releaseSwapchainImage)},
        {"xrWaitFrame", at(&waitFrame)},
        {"xrBeginFrame", at(&beginFrame)},
        {"xrEndFrame", at(&endFrame)},
        {"xrLocateViews", at(&locateViews)},
        {"xrStringToPath", at(&stringToPath)},
        {"xrPathToString", at(&pathToString)},
        {"xrCreateActionSet", at(&createActionSet)},
        {"xrDestroyActionSet", at(&destroyActionSet)},
        {"xrCreateAction", at(&createAction)},
        {"xrDestroyAction", at(&destroyAction)},
        {"xrSuggestInteractionProfileBindings", at(&suggestInteractionProfileBindings)},
        {"xrAttachSessionActionSets", at(&attachSessionActionSets)},
        {"xrSyncActions", at(&syncActions)},
        {"xrGetCurrentInteractionProfile", at(&getCurrentInteractionProfile)},
        {"xrGetActionStateBoolean", at(&getActionStateBoolean)},
        {"xrGetActionStateFloat", at(&getActionStateFloat)},
        {"xrGetActionStateVector2f", at(&getActionStateVector2f)},
        {"xrGetActionStatePose", at(&getActionStatePose)},
        {"xrApplyHapticFeedback", at(&applyHapticFeedback)},
        {"xrStopHapticFeedback", at(&stopHapticFeedback)},
    };
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

} // namespace ductus::xr
