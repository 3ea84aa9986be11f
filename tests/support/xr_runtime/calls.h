// The functions of the runtime, by the file they are in.
#pragma once

#include "support/xr_runtime/runtime.h"

namespace ductus::xr {

// instance_calls.cpp
XrResult XRAPI_CALL enumerateInstanceExtensionProperties(const char *layer, std::uint32_t capacity,
                                                         std::uint32_t *count,
                                                         XrExtensionProperties *properties);
XrResult XRAPI_CALL createInstance(const XrInstanceCreateInfo *info, XrInstance *instance);
XrResult XRAPI_CALL destroyInstance(XrInstance);
XrResult XRAPI_CALL getInstanceProperties(XrInstance, XrInstanceProperties *properties);
XrResult XRAPI_CALL pollEvent(XrInstance, XrEventDataBuffer *event);
XrResult XRAPI_CALL resultToString(XrInstance, XrResult value, char buffer[XR_MAX_RESULT_STRING_SIZE]);
XrResult XRAPI_CALL structureTypeToString(XrInstance, XrStructureType value,
                                          char buffer[XR_MAX_STRUCTURE_NAME_SIZE]);
XrResult XRAPI_CALL getSystem(XrInstance, const XrSystemGetInfo *info, XrSystemId *system);
XrResult XRAPI_CALL getSystemProperties(XrInstance, XrSystemId system, XrSystemProperties *properties);
XrResult XRAPI_CALL enumerateEnvironmentBlendModes(XrInstance, XrSystemId system,
                                                   XrViewConfigurationType configuration,
                                                   std::uint32_t capacity, std::uint32_t *count,
                                                   XrEnvironmentBlendMode *modes);
XrResult XRAPI_CALL enumerateViewConfigurations(XrInstance, XrSystemId, std::uint32_t capacity,
                                                std::uint32_t *count, XrViewConfigurationType *types);
XrResult XRAPI_CALL getViewConfigurationProperties(XrInstance, XrSystemId, XrViewConfigurationType type,
                                                   XrViewConfigurationProperties *properties);
XrResult XRAPI_CALL enumerateViewConfigurationViews(XrInstance, XrSystemId, XrViewConfigurationType type,
                                                    std::uint32_t capacity, std::uint32_t *count,
                                                    XrViewConfigurationView *views);
XrResult XRAPI_CALL getOpenGlGraphicsRequirements(XrInstance, XrSystemId system,
                                                  XrGraphicsRequirementsOpenGLKHR *requirements);

// session_calls.cpp
XrResult XRAPI_CALL createSession(XrInstance, const XrSessionCreateInfo *info, XrSession *session);
XrResult XRAPI_CALL destroySession(XrSession session);
XrResult XRAPI_CALL beginSession(XrSession session, const XrSessionBeginInfo *info);
XrResult XRAPI_CALL endSession(XrSession session);
XrResult XRAPI_CALL requestExitSession(XrSession session);
XrResult XRAPI_CALL enumerateReferenceSpaces(XrSession session, std::uint32_t capacity, std::uint32_t *count,
                                             XrReferenceSpaceType *types);
XrResult XRAPI_CALL createReferenceSpace(XrSession session, const XrReferenceSpaceCreateInfo *info,
                                         XrSpace *space);
XrResult XRAPI_CALL getReferenceSpaceBoundsRect(XrSession session, XrReferenceSpaceType, XrExtent2Df *bounds);
XrResult XRAPI_CALL createActionSpace(XrSession session, const XrActionSpaceCreateInfo *info, XrSpace *space);
XrResult XRAPI_CALL locateSpace(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation *location);
XrResult XRAPI_CALL destroySpace(XrSpace space);

// swapchain_calls.cpp
XrResult XRAPI_CALL enumerateSwapchainFormats(XrSession session, std::uint32_t capacity, std::uint32_t *count,
                                              std::int64_t *formats);
XrResult XRAPI_CALL createSwapchain(XrSession session, const XrSwapchainCreateInfo *info,
                                    XrSwapchain *swapchain);
XrResult XRAPI_CALL destroySwapchain(XrSwapchain swapchain);
XrResult XRAPI_CALL enumerateSwapchainImages(XrSwapchain swapchain, std::uint32_t capacity,
                                             std::uint32_t *count, XrSwapchainImageBaseHeader *images);
XrResult XRAPI_CALL acquireSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageAcquireInfo *,
                                          std::uint32_t *index);
XrResult XRAPI_CALL waitSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageWaitInfo *);
XrResult XRAPI_CALL releaseSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageReleaseInfo *);

// frame_calls.cpp
XrResult XRAPI_CALL waitFrame(XrSession session, const XrFrameWaitInfo *, XrFrameState *state);
XrResult XRAPI_CALL beginFrame(XrSession session, const XrFrameBeginInfo *);
XrResult XRAPI_CALL endFrame(XrSession session, const XrFrameEndInfo *info);
XrResult XRAPI_CALL locateViews(XrSession session, const XrViewLocateInfo *info, XrViewState *state,
                                std::uint32_t capacity, std::uint32_t *count, XrView *views);

// action_calls.cpp
XrResult XRAPI_CALL stringToPath(XrInstance, const char *string, XrPath *path);
XrResult XRAPI_CALL pathToString(XrInstance, XrPath path, std::uint32_t capacity, std::uint32_t *count,
                                 char *buffer);
XrResult XRAPI_CALL createActionSet(XrInstance, const XrActionSetCreateInfo *info, XrActionSet *set);
XrResult XRAPI_CALL destroyActionSet(XrActionSet set);
XrResult XRAPI_CALL createAction(XrActionSet set, const XrActionCreateInfo *info, XrAction *action);
XrResult XRAPI_CALL destroyAction(XrAction action);
XrResult XRAPI_CALL suggestInteractionProfileBindings(XrInstance,
                                                      const XrInteractionProfileSuggestedBinding *suggestion);
XrResult XRAPI_CALL attachSessionActionSets(XrSession session, const XrSessionActionSetsAttachInfo *info);

// input_calls.cpp
XrResult XRAPI_CALL syncActions(XrSession session, const XrActionsSyncInfo *info);
XrResult XRAPI_CALL getCurrentInteractionProfile(XrSession session, XrPath user,
                                                 XrInteractionProfileState *state);
XrResult XRAPI_CALL getActionStateBoolean(XrSession session, const XrActionStateGetInfo *info,
                                          XrActionStateBoolean *state);
XrResult XRAPI_CALL getActionStateFloat(XrSession session, const XrActionStateGetInfo *info,
                                        XrActionStateFloat *state);
XrResult XRAPI_CALL getActionStateVector2f(XrSession session, const XrActionStateGetInfo *info,
                                           XrActionStateVector2f *state);
XrResult XRAPI_CALL getActionStatePose(XrSession session, const XrActionStateGetInfo *info,
                                       XrActionStatePose *state);
XrResult XRAPI_CALL applyHapticFeedback(XrSession session, const XrHapticActionInfo *info,
                                        const XrHapticBaseHeader *haptic);
XrResult XRAPI_CALL stopHapticFeedback(XrSession session, const XrHapticActionInfo *);

} // namespace ductus::xr
