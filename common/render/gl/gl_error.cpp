#include "render/gl/gl_error.h"

#include <epoxy/gl.h>

namespace ductus {

namespace {

const char *nameOf(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM:
        return "invalid enum";
    case GL_INVALID_VALUE:
        return "invalid value";
    case GL_INVALID_OPERATION:
        return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY:
        return "out of memory";
    case GL_CONTEXT_LOST:
        return "the graphics card was reset";
    default:
        return "unknown error";
    }
}

} // namespace

Result<void> checkGl(const char *attempted)
{
    std::string problems;
    bool outOfMemory = false;
    // A lost context reports for ever.
    for (int i = 0; i < 16; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR)
            break;
        outOfMemory |= error == GL_OUT_OF_MEMORY;
        problems += (problems.empty() ? "" : ", ") + std::string(nameOf(error));
        if (error == GL_CONTEXT_LOST)
            break;
    }
    if (problems.empty())
        return {};
    return Error{outOfMemory ? ErrorCode::TooLarge : ErrorCode::Unsupported,
                 attempted,
                 "OpenGL reports: " + problems,
                 outOfMemory ? "Use a smaller picture or fewer samples"
                             : "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1",
                 {}};
}

Result<void> checkGlVersion(const char *attempted)
{
    const int version = epoxy_gl_version();
    if (epoxy_is_desktop_gl() && version >= 43)
        return {};
    const auto *renderer = reinterpret_cast<const char *>(glGetString(GL_RENDERER));
    return Error{ErrorCode::Unsupported,
                 attempted,
                 "OpenGL 4.3 is needed, and " + std::string(renderer ? renderer : "this graphics card") +
                     " offers " + std::to_string(version / 10) + "." + std::to_string(version % 10),
                 "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1",
                 {}};
}

} // namespace ductus
