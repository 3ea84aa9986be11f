#include "layerpainter/vr/session/glx_binding.h"

#include "layerpainter/vr/session/headset_runtime.h"
#include "layerpainter/vr/session/xr_words.h"

#include <epoxy/gl.h>
#include <epoxy/glx.h>

#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

namespace ductus {

namespace {

constexpr const char *attempted = "Entering VR";

Error noGlx()
{
    return {ErrorCode::Unsupported,
            attempted,
            "the window's OpenGL context is not one of X11 (GLX), which headset software needs",
            "Start LayerPainter in an X11 session, or with QT_QPA_PLATFORM=xcb and without "
            "QT_XCB_GL_INTEGRATION",
            {}};
}

Result<XrGraphicsBindingOpenGLXlibKHR> currentBinding()
{
    auto binding = xrStruct<XrGraphicsBindingOpenGLXlibKHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
    binding.glxContext = glXGetCurrentContext();
    binding.xDisplay = glXGetCurrentDisplay();
    binding.glxDrawable = glXGetCurrentDrawable();
    if (!binding.glxContext || !binding.xDisplay || !binding.glxDrawable)
        return noGlx();
    int config = 0, count = 0;
    glXQueryContext(binding.xDisplay, binding.glxContext, GLX_FBCONFIG_ID, &config);
    const int wanted[] = {GLX_FBCONFIG_ID, config, 0};
    GLXFBConfig *found = glXChooseFBConfig(binding.xDisplay, DefaultScreen(binding.xDisplay), wanted, &count);
    if (!found || count == 0)
        return noGlx();
    binding.glxFBConfig = found[0];
    XFree(found);
    if (XVisualInfo *visual = glXGetVisualFromFBConfig(binding.xDisplay, binding.glxFBConfig)) {
        binding.visualid = std::uint32_t(visual->visualid);
        XFree(visual);
    }
    return binding;
}

// A function the loader does not export; it must be asked for before a session is made.
Result<void> checkVersion(const HeadsetRuntime &runtime)
{
    PFN_xrGetOpenGLGraphicsRequirementsKHR ask = nullptr;
    const char *name = "xrGetOpenGLGraphicsRequirementsKHR";
    XrResult result =
        xrGetInstanceProcAddr(runtime.instance(), name, reinterpret_cast<PFN_xrVoidFunction *>(&ask));
    if (XR_FAILED(result) || !ask)
        return xrError(attempted, name, XR_ERROR_EXTENSION_NOT_PRESENT);
    auto needs = xrStruct<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    result = ask(runtime.instance(), runtime.system(), &needs);
    if (XR_FAILED(result))
        return xrError(attempted, name, result);
    int major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    const auto present = XR_MAKE_VERSION(major, minor, 0);
    if (present < needs.minApiVersionSupported) // newer than "supported" is said to work as well
        return Error{ErrorCode::Unsupported, attempted,
                     "the headset software needs OpenGL " +
                         std::to_string(XR_VERSION_MAJOR(needs.minApiVersionSupported)) + "." +
                         std::to_string(XR_VERSION_MINOR(needs.minApiVersionSupported)) + ", here is " +
                         std::to_string(major) + "." + std::to_string(minor),
                     "Update the graphics driver", name};
    return {};
}

} // namespace

Result<XrSession> createGlxSession(const HeadsetRuntime &runtime)
{
    Result<XrGraphicsBindingOpenGLXlibKHR> binding = currentBinding();
    if (!binding)
        return binding.error();
    if (Result<void> enough = checkVersion(runtime); !enough)
        return enough.error();
    auto info = xrStruct<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    info.next = &*binding;
    info.systemId = runtime.system();
    XrSession session = XR_NULL_HANDLE;
    const XrResult made = xrCreateSession(runtime.instance(), &info, &session);
    glXMakeCurrent(binding->xDisplay, binding->glxDrawable, binding->glxContext);
    if (XR_FAILED(made))
        return xrError(attempted, "xrCreateSession", made);
    return session;
}

} // namespace ductus
