#include "render/gl/offscreen_context.h"

#include "render/gl/gl_error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdio>
#include <utility>

namespace ductus {

namespace {

constexpr const char *attempted = "Opening OpenGL without a window";

Error failure(const std::string &problem)
{
    std::array<char, 16> code;
    std::snprintf(code.data(), code.size(), "0x%04x", unsigned(eglGetError()));
    return {ErrorCode::Unsupported,
            attempted,
            problem + " (EGL error " + code.data() + ")",
            "Install the packages libegl1 and libgl1-mesa-dri",
            {}};
}

bool has(EGLDisplay display, const char *extension)
{
    return epoxy_has_egl_extension(display, extension);
}

/// Initialized; EGL_NO_DISPLAY if there is none.
EGLDisplay openDisplay()
{
    if (has(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
        has(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
        const EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
            return display;
    }
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
        return display;
    return EGL_NO_DISPLAY;
}

} // namespace

Result<OffscreenContext> OffscreenContext::create()
{
    OffscreenContext made;
    made.mDisplay = openDisplay();
    if (made.mDisplay == EGL_NO_DISPLAY)
        return failure("no EGL display can be opened");
    if (!eglBindAPI(EGL_OPENGL_API))
        return failure("EGL offers no desktop OpenGL");
    const EGLint configWish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                 EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(made.mDisplay, configWish, &config, 1, &count) || count == 0)
        return failure("EGL has no configuration for desktop OpenGL");
    const EGLint contextWish[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  4,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    made.mContext = eglCreateContext(made.mDisplay, config, EGL_NO_CONTEXT, contextWish);
    if (made.mContext == EGL_NO_CONTEXT)
        return failure("the driver does not offer OpenGL 4.3 core");
    if (!has(made.mDisplay, "EGL_KHR_surfaceless_context")) {
        const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        made.mSurface = eglCreatePbufferSurface(made.mDisplay, config, size);
        if (made.mSurface == EGL_NO_SURFACE)
            return failure("EGL makes no surface of one pixel");
    }
    if (Result<void> done = made.makeCurrent(); !done)
        return done.error();
    if (Result<void> enough = checkGlVersion(attempted); !enough)
        return enough.error();
    return made;
}

OffscreenContext::OffscreenContext(OffscreenContext &&other) noexcept
    : mDisplay(std::exchange(other.mDisplay, nullptr)), mContext(std::exchange(other.mContext, nullptr)),
      mSurface(std::exchange(other.mSurface, nullptr))
{
}

OffscreenContext &OffscreenContext::operator=(OffscreenContext &&other) noexcept
{
    std::swap(mDisplay, other.mDisplay);
    std::swap(mContext, other.mContext);
    std::swap(mSurface, other.mSurface);
    return *this;
}

OffscreenContext::~OffscreenContext()
{
    if (!mContext)
        return;
    if (eglGetCurrentContext() == mContext)
        release();
    if (mSurface)
        eglDestroySurface(mDisplay, mSurface);
    eglDestroyContext(mDisplay, mContext);
    // The display stays: it is the process's, eglTerminate would end every other context on it, Qt's too.
}

Result<void> OffscreenContext::makeCurrent()
{
    eglBindAPI(EGL_OPENGL_API);
    if (!eglMakeCurrent(mDisplay, mSurface, mSurface, mContext))
        return failure("the context cannot be used on this thread");
    return {};
}

void OffscreenContext::release()
{
    eglMakeCurrent(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

std::string OffscreenContext::description() const
{
    const auto *renderer = reinterpret_cast<const char *>(glGetString(GL_RENDERER));
    const int version = epoxy_gl_version();
    return std::string(renderer ? renderer : "unknown") + ", OpenGL " + std::to_string(version / 10) + "." +
           std::to_string(version % 10);
}

} // namespace ductus
