// Owners of OpenGL names: made by create(), deleted with the owner while the same context is current.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace ductus {

template <typename Kind>
class GlObject
{
public:
    GlObject() = default;
    static GlObject create()
    {
        GlObject object;
        Kind::create(object.mName);
        return object;
    }
    GlObject(GlObject &&other) noexcept : mName(std::exchange(other.mName, 0)) {}
    GlObject &operator=(GlObject &&other) noexcept
    {
        std::swap(mName, other.mName);
        return *this;
    }
    GlObject(const GlObject &) = delete;
    GlObject &operator=(const GlObject &) = delete;
    ~GlObject()
    {
        if (mName)
            Kind::destroy(mName);
    }

    GLuint name() const { return mName; }
    explicit operator bool() const { return mName != 0; }

private:
    GLuint mName = 0;
};

struct GlBufferKind
{
    static void create(GLuint &name) { glGenBuffers(1, &name); }
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct GlTextureKind
{
    static void create(GLuint &name) { glGenTextures(1, &name); }
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct GlFramebufferKind
{
    static void create(GLuint &name) { glGenFramebuffers(1, &name); }
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct GlVertexArrayKind
{
    static void create(GLuint &name) { glGenVertexArrays(1, &name); }
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct GlProgramKind
{
    static void create(GLuint &name) { name = glCreateProgram(); }
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

using GlBuffer = GlObject<GlBufferKind>;
using GlTexture = GlObject<GlTextureKind>;
using GlFramebuffer = GlObject<GlFramebufferKind>;
using GlVertexArray = GlObject<GlVertexArrayKind>;
using GlProgram = GlObject<GlProgramKind>;

} // namespace ductus
