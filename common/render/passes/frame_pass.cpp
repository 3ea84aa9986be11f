#include "render/passes/frame_pass.h"

#include "render/passes/appearance_pass.h"
#include "render/passes/element_pass.h"

namespace ductus {

namespace {

Result<void> drawSubstrates(FrameContext &frame, int peel, bool peeling)
{
    frame.bindTarget(frame.buffers.substrateTarget);
    frame.setScissor(frame.whole());
    constexpr std::array<float, 4> black{};
    constexpr std::array<GLuint, 4> nothing{};
    constexpr float farthest = 0;
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, black.data());
    glClearBufferuiv(GL_COLOR, 1, nothing.data());
    glClearBufferuiv(GL_COLOR, 2, nothing.data());
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDisable(GL_BLEND);
    if (peeling) {
        glActiveTexture(GL_TEXTURE4);
        glBindTexture(frame.buffers.samples() > 1 ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_ARRAY,
                      frame.buffers.peeled.name());
    }
    for (const DrawnStack &stack : frame.painting.stacks())
        if (Result<void> done = drawSubstrate(frame, stack.substrate, peel, peeling); !done)
            return done;
    return {};
}

/// The surface that is ready goes behind those before it.
Result<void> accumulate(FrameContext &frame)
{
    const Result<const Program *> program = frame.programs.accumulate();
    if (!program)
        return program.error();
    frame.bindTarget(frame.buffers.accumulatedTarget);
    frame.setScissor(frame.whole());
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    frame.buffers.bind(1, frame.buffers.colour);
    (*program)->use();
    frame.drawWholeFrame();
    return {};
}

Result<void> drawPeels(FrameContext &frame, MaskBlocks &blocks)
{
    if (Result<void> room = frame.buffers.addPeeling(mostSurfaces); !room)
        return room;
    frame.bindTarget(frame.buffers.accumulatedTarget);
    frame.setScissor(frame.whole());
    constexpr std::array<float, 4> none{};
    glClearBufferfv(GL_COLOR, 0, none.data());
    for (int peel = 0; peel < mostSurfaces; ++peel) {
        AnySamples anything;
        anything.begin();
        if (Result<void> done = drawSubstrates(frame, peel, true); !done)
            return done;
        if (!anything.end())
            break;
        ++frame.statistics.peels;
        frame.buffers.keepPeeled(peel);
        if (Result<void> done = drawAppearances(frame, blocks); !done)
            return done;
        if (Result<void> done = accumulate(frame); !done)
            return done;
    }
    return {};
}

} // namespace

bool needsPeeling(const PaintingUpload &painting)
{
    return std::any_of(painting.stacks().begin(), painting.stacks().end(),
                       [](const DrawnStack &stack) { return stack.substrate.isTranslucent; });
}

Result<void> drawFrame(FrameContext &frame, MaskBlocks &blocks)
{
    // Whoever drew before in this context (QPainter, VTK) may have left anything.
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_PRIMITIVE_RESTART);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glDisable(GL_RASTERIZER_DISCARD);
    glDisable(GL_COLOR_LOGIC_OP);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBlendEquation(GL_FUNC_ADD);
    glFrontFace(GL_CCW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    for (int unit = 0; unit <= 4; ++unit)
        glBindSampler(GLuint(unit), 0);
    glViewport(0, 0, frame.buffers.width(), frame.buffers.height());
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_CLAMP);
    frame.painting.bindElements();
    if (needsPeeling(frame.painting))
        return drawPeels(frame, blocks);
    if (Result<void> done = drawSubstrates(frame, 0, false); !done)
        return done;
    return drawAppearances(frame, blocks);
}

Result<void> presentFrame(FrameContext &frame, bool transparent, int x, int y)
{
    const Result<const Program *> program = frame.programs.present();
    if (!program)
        return program.error();
    const bool peeled = needsPeeling(frame.painting);
    const Eigen::Vector3f background = inBlendSpace(frame.painting.blendSpace(), frame.painting.background());
    glViewport(x, y, frame.buffers.width(), frame.buffers.height());
    glScissor(x, y, frame.buffers.width(), frame.buffers.height());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    frame.buffers.bind(1, peeled ? frame.buffers.accumulated : frame.buffers.colour);
    (*program)->use();
    const float alpha = transparent ? 0.f : 1.f;
    glUniform4f((*program)->at("background"), alpha * background[0], alpha * background[1],
                alpha * background[2], alpha);
    glUniform2i((*program)->at("corner"), x, y);
    glUniform1i((*program)->at("isPremultiplied"), peeled);
    frame.drawWholeFrame();
    return {};
}

} // namespace ductus
