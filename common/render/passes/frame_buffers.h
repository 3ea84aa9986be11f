// The pictures a frame is made in: what is seen, where it is, whose it is, and the layer in work.
#pragma once

#include "base/result.h"
#include "render/gl/gl_object.h"

#include <cstdint>
#include <initializer_list>

namespace ductus {

class FrameBuffers
{
public:
    /// \a samples 1 or more; fewer if the card has no more. TooLarge beyond the card's size or memory.
    static Result<FrameBuffers> create(int width, int height, int samples);

    int width() const { return mWidth; }
    int height() const { return mHeight; }
    int samples() const { return mSamples; }

    GlTexture colour;   // RGBA16: straight colour in blend space, opacity
    GlTexture surface;  // RG32UI: stack id (0: nothing), bits of the depth along the view
    GlTexture element;  // R32UI: element id
    GlTexture depth;    // D32F: nearer is larger
    GlTexture layer;    // RGBA16: a layer's own premultiplied colour
    GlTexture order;    // D32F: drawing order, order.glsl
    GlTexture mask;     // R16: product of masks
    GlTexture coverage; // R8: where a mask layer's strokes are
    GlTexture winding;  // R16F: how often meshes wind around the surface point
    // Only after addPeeling():
    GlTexture accumulated;  // RGBA16: premultiplied, surfaces from front to back
    GlTexture peeled;       // R32UI array: elements of the surfaces before
    GlTexture firstSurface; // as surface, of the first one

    GlFramebuffer substrateTarget; // colour, surface, element; depth
    GlFramebuffer colourTarget;    // colour
    GlFramebuffer layerTarget;     // layer; order
    GlFramebuffer straightTarget;  // colour; order
    GlFramebuffer maskTarget;      // mask
    GlFramebuffer coverageTarget;  // coverage
    GlFramebuffer windingTarget;   // winding
    GlFramebuffer accumulatedTarget;

    /// Of textures here.
    GLenum textureTarget() const { return mSamples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D; }
    void bind(int unit, const GlTexture &texture) const;

    /// What translucent substrates need; nothing if it is there already.
    Result<void> addPeeling(int surfaces);
    /// Notes the surface that was drawn as the one of that number.
    void keepPeeled(int number) const;

    /// Before the frame's colour is read while it is drawn to; within a rectangle.
    void makeReadable(int x, int y, int width, int height);
    /// What to read then: the colour itself, or a copy where the card cannot do that.
    const GlTexture &backdrop() const { return mCopy ? mCopy : colour; }

    struct Place
    {
        std::int32_t stack = 0; // 0: nothing
        std::int32_t element = 0;
        float depth = 0;
    };
    /// What the last frame shows at a pixel, rows from the bottom; waits for the card.
    Result<Place> placeAt(int x, int y, bool peeling) const;

private:
    GlTexture makeTexture(GLenum format, GLenum pixelFormat, GLenum pixelType) const;
    Result<GlFramebuffer> makeTarget(std::initializer_list<const GlTexture *> colours,
                                     const GlTexture *depth) const;

    int mWidth = 0, mHeight = 0, mSamples = 1;
    GlTexture mCopy; // of colour
};

} // namespace ductus
