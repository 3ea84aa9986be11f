// The method of the published prototype (thesis V.5), to compare with: meshes of tubes, stencil bits, three
// draws a stroke. Only for benchmarks.
#pragma once

#include "base/result.h"
#include "painting/reference/frame_camera.h"
#include "painting/scene/painting.h"
#include "render/gl/gl_object.h"

namespace ductus {

class StencilBaseline
{
public:
    static Result<StencilBaseline> create(const Painting &painting, int width, int height);

    /// Into its own framebuffer. \a withLayers false: the shapes alone.
    void draw(const FrameCamera &camera, bool withLayers = true);
    GLuint framebuffer() const { return mTarget.name(); }

private:
    struct Range
    {
        GLint first;
        GLsizei count;
    };

    int mWidth = 0, mHeight = 0;
    std::vector<Range> mSubstrate;
    struct LayerRanges
    {
        std::vector<Range> strokes;
        int mode = 0; // copyFragment
        float opacity = 1;
    };
    void composite(const LayerRanges &layer);

    std::vector<LayerRanges> mLayers;
    GlBuffer mVertices, mIndices;
    GlVertexArray mArray, mNothing;
    GlProgram mTubes, mBlend;
    GlTexture mColour, mCopy, mLayer, mDepth;
    GlFramebuffer mTarget, mLayerTarget;
};

} // namespace ductus
