#include "render/passes/frame_buffers.h"

#include "render/gl/gl_error.h"

#include <algorithm>
#include <array>
#include <bit>

namespace ductus {

namespace {
constexpr const char *attempted = "Preparing the frame";
}

Result<FrameBuffers> FrameBuffers::create(int width, int height, int samples)
{
    GLint largest = 0, most = 1;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    glGetIntegerv(GL_MAX_INTEGER_SAMPLES, &most);
    GLint mostColour = 1, mostDepth = 1;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &mostColour);
    glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &mostDepth);
    if (width < 1 || height < 1)
        return Error{ErrorCode::InvalidArgument,
                     attempted,
                     "the picture has no size",
                     "Ask for at least one pixel",
                     {}};
    if (width > largest || height > largest)
        return Error{ErrorCode::TooLarge,
                     attempted,
                     "this graphics card draws no more than " + std::to_string(largest) + " pixels a side",
                     "Ask for a smaller picture",
                     {}};
    FrameBuffers made;
    made.mWidth = width;
    made.mHeight = height;
    made.mSamples = std::clamp(samples, 1, std::max(1, std::min({most, mostColour, mostDepth})));
    made.colour = made.makeTexture(GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT);
    made.surface = made.makeTexture(GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT);
    made.element = made.makeTexture(GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
    made.depth = made.makeTexture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    made.layer = made.makeTexture(GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT);
    made.order = made.makeTexture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    made.mask = made.makeTexture(GL_R16, GL_RED, GL_UNSIGNED_SHORT);
    made.coverage = made.makeTexture(GL_R8, GL_RED, GL_UNSIGNED_BYTE);
    made.winding = made.makeTexture(GL_R16F, GL_RED, GL_HALF_FLOAT);

    const auto make = [&](GlFramebuffer &target, std::initializer_list<const GlTexture *> colours,
                          const GlTexture *depth) -> Result<void> {
        Result<GlFramebuffer> done = made.makeTarget(colours, depth);
        if (!done)
            return done.error();
        target = std::move(*done);
        return {};
    };
    for (const Result<void> &done :
         {make(made.substrateTarget, {&made.colour, &made.surface, &made.element}, &made.depth),
          make(made.colourTarget, {&made.colour}, nullptr),
          make(made.layerTarget, {&made.layer}, &made.order),
          make(made.straightTarget, {&made.colour}, &made.order),
          make(made.maskTarget, {&made.mask}, nullptr), make(made.coverageTarget, {&made.coverage}, nullptr),
          make(made.windingTarget, {&made.winding}, nullptr)})
        if (!done)
            return done.error();
    if (const Result<void> fine = checkGl(attempted); !fine)
        return fine.error();
    return made;
}

GlTexture FrameBuffers::makeTexture(GLenum format, GLenum pixelFormat, GLenum pixelType) const
{
    GlTexture texture = GlTexture::create();
    glBindTexture(textureTarget(), texture.name());
    if (mSamples > 1) {
        glTexStorage2DMultisample(textureTarget(), mSamples, format, mWidth, mHeight, GL_TRUE);
    } else {
        glTexStorage2D(textureTarget(), 1, format, mWidth, mHeight);
        glTexParameteri(textureTarget(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(textureTarget(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glBindTexture(textureTarget(), 0);
    return texture;
}

Result<GlFramebuffer> FrameBuffers::makeTarget(std::initializer_list<const GlTexture *> colours,
                                               const GlTexture *depthTexture) const
{
    GlFramebuffer target = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    std::array<GLenum, 4> draw{};
    GLenum attachment = GL_COLOR_ATTACHMENT0;
    for (const GlTexture *texture : colours) {
        draw[attachment - GL_COLOR_ATTACHMENT0] = attachment;
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment++, textureTarget(), texture->name(), 0);
    }
    glDrawBuffers(GLsizei(colours.size()), draw.data());
    if (depthTexture)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, textureTarget(), depthTexture->name(), 0);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return Error{ErrorCode::Unsupported,
                     attempted,
                     "the graphics card cannot draw into the pictures a painting needs (status " +
                         std::to_string(status) + ")",
                     "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1",
                     {}};
    return target;
}

void FrameBuffers::bind(int unit, const GlTexture &texture) const
{
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(textureTarget(), texture.name());
}

Result<void> FrameBuffers::addPeeling(int surfaces)
{
    if (accumulated)
        return {};
    accumulated = makeTexture(GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT);
    firstSurface = makeTexture(GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT);
    peeled = GlTexture::create();
    const GLenum target = mSamples > 1 ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_ARRAY;
    glBindTexture(target, peeled.name());
    if (mSamples > 1) {
        glTexStorage3DMultisample(target, mSamples, GL_R32UI, mWidth, mHeight, surfaces, GL_TRUE);
    } else {
        glTexStorage3D(target, 1, GL_R32UI, mWidth, mHeight, surfaces);
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glBindTexture(target, 0);
    Result<GlFramebuffer> made = makeTarget({&accumulated}, nullptr);
    if (!made)
        return made.error();
    accumulatedTarget = std::move(*made);
    return checkGl(attempted);
}

void FrameBuffers::keepPeeled(int number) const
{
    const GLenum array = mSamples > 1 ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_ARRAY;
    glCopyImageSubData(element.name(), textureTarget(), 0, 0, 0, 0, peeled.name(), array, 0, 0, 0, number,
                       mWidth, mHeight, 1);
    if (number == 0)
        glCopyImageSubData(surface.name(), textureTarget(), 0, 0, 0, 0, firstSurface.name(), textureTarget(),
                           0, 0, 0, 0, mWidth, mHeight, 1);
}

void FrameBuffers::makeReadable(int x, int y, int width, int height)
{
    if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_texture_barrier")) {
        glTextureBarrier();
        return;
    }
    if (!mCopy)
        mCopy = makeTexture(GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT);
    glCopyImageSubData(colour.name(), textureTarget(), 0, x, y, 0, mCopy.name(), textureTarget(), 0, x, y, 0,
                       width, height, 1);
}

Result<FrameBuffers::Place> FrameBuffers::placeAt(int x, int y, bool peeling) const
{
    const GlFramebuffer source = GlFramebuffer::create(), single = GlFramebuffer::create();
    std::array<GlTexture, 2> pixels{GlTexture::create(), GlTexture::create()};
    const std::array<GLenum, 2> formats{GL_RG32UI, GL_R32UI};
    std::array<std::array<GLuint, 2>, 2> values{};
    for (std::size_t i = 0; i < 2; ++i) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, source.name());
        if (i == 1 && peeling)
            glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, peeled.name(), 0, 0);
        else
            glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, textureTarget(),
                                   (i == 1    ? element
                                    : peeling ? firstSurface
                                              : surface)
                                       .name(),
                                   0);
        // Samples cannot be read; of integers a blit takes one of them.
        glBindTexture(GL_TEXTURE_2D, pixels[i].name());
        glTexStorage2D(GL_TEXTURE_2D, 1, formats[i], 1, 1);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single.name());
        glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, pixels[i].name(), 0);
        glDisable(GL_SCISSOR_TEST);
        glBlitFramebuffer(x, y, x + 1, y + 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, single.name());
        glReadPixels(0, 0, 1, 1, i == 0 ? GL_RG_INTEGER : GL_RED_INTEGER, GL_UNSIGNED_INT, values[i].data());
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (const Result<void> fine = checkGl("Looking what is there"); !fine)
        return fine.error();
    return Place{std::int32_t(values[0][0]), std::int32_t(values[1][0]), std::bit_cast<float>(values[0][1])};
}

} // namespace ductus
