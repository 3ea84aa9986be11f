#include "render/passes/frame_context.h"

#include "painting/blend/blend.h"

namespace ductus {

void FrameContext::bindTarget(const GlFramebuffer &target) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
}

void FrameContext::setScissor(const PixelRect &rect) const
{
    glScissor(rect.left, rect.bottom, rect.width(), rect.height());
}

void FrameContext::drawWholeFrame()
{
    glBindVertexArray(nothing.name());
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ++statistics.draws;
}

LayerInView FrameContext::lookAt(const DrawnLayer &layer, const ElementsWanted &wanted) const
{
    LayerInView inView = layerInView(layer, screen, detail, wanted);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands.name());
    if (!inView.commands.empty())
        glBufferData(GL_DRAW_INDIRECT_BUFFER, GLsizeiptr(inView.commands.size() * sizeof(DrawCommand)),
                     inView.commands.data(), GL_STREAM_DRAW);
    return inView;
}

Eigen::Vector3f inBlendSpace(BlendSpace space, const Eigen::Vector3f &linear)
{
    return toBlendSpace(space, linear.cast<double>()).cast<float>();
}

} // namespace ductus
