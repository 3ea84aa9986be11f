// What the passes of a frame share.
#pragma once

#include "render/passes/drawing_runs.h"
#include "render/passes/frame_buffers.h"
#include "render/passes/programs.h"
#include "render/passes/ribbon_plan.h"

namespace ductus {

/// What a frame cost.
struct FrameStatistics
{
    int draws = 0;
    std::uint64_t segments = 0; // boxes sent through the pipeline
    std::uint64_t ribbonVertices = 0;
    int peels = 0; // translucent surfaces behind each other, at most
};

struct FrameContext
{
    PaintingUpload &painting;
    Programs &programs;
    FrameBuffers &buffers;
    const GlBuffer &commands;     // for indirect draws
    const GlVertexArray &nothing; // for whole-frame triangles
    FrameCamera camera;
    ScreenFinder screen;
    Detail detail;
    RibbonPlan ribbons;          // what of the substrates is drawn as such
    std::uint32_t orderBase = 0; // of the next layer, order.glsl
    FrameStatistics statistics;

    PixelRect whole() const { return {0, 0, buffers.width(), buffers.height()}; }
    void bindTarget(const GlFramebuffer &target) const;
    void setScissor(const PixelRect &rect) const;
    void drawWholeFrame();
    /// The visible elements of a layer, its commands sent.
    LayerInView lookAt(const DrawnLayer &layer, const ElementsWanted &wanted) const;
};

/// Whether anything was drawn between two calls; waits for the card.
class AnySamples
{
public:
    AnySamples() { glGenQueries(1, &mQuery); }
    ~AnySamples() { glDeleteQueries(1, &mQuery); }
    AnySamples(const AnySamples &) = delete;
    AnySamples &operator=(const AnySamples &) = delete;
    void begin() { glBeginQuery(GL_ANY_SAMPLES_PASSED, mQuery); }
    bool end()
    {
        GLuint any = 0;
        glEndQuery(GL_ANY_SAMPLES_PASSED);
        glGetQueryObjectuiv(mQuery, GL_QUERY_RESULT, &any);
        return any != 0;
    }

private:
    GLuint mQuery = 0;
};

/// A colour in the numbers the frame is blended in.
Eigen::Vector3f inBlendSpace(BlendSpace space, const Eigen::Vector3f &linear);

} // namespace ductus
