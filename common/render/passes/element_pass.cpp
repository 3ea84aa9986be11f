#include "render/passes/element_pass.h"

#include <bit>
#include <cmath>

namespace ductus {

namespace {

using Pass = SegmentProgramKind::Pass;

Reach reachOf(const DrawnLayer &layer)
{
    if (!(layer.tolerance > 0))
        return Reach::Inside;
    return layer.toleranceMode == ToleranceMode::View ? Reach::View : Reach::Surface;
}

void setLayerColour(const Program &program, const DrawnLayer &layer)
{
    const Eigen::Vector3f colour = layer.properties.colour.value_or(Eigen::Vector3f::Zero());
    glUniform4f(program.at("layerColour"), colour[0], colour[1], colour[2],
                layer.properties.colour ? 1.f : 0.f);
}

class ElementDrawing
{
public:
    ElementDrawing(FrameContext &frame, const DrawnLayer &layer, Pass pass, StackId onlyStack)
        : mFrame(frame), mLayer(layer), mPass(pass), mOnlyStack(onlyStack),
          mReach(pass == Pass::Substrate ? Reach::Inside : reachOf(layer))
    {
    }

    Result<void> draw(const LayerInView &inView)
    {
        for (const DrawingRun &run : inView.runs)
            if (Result<void> done = run.mesh ? drawMesh(run) : drawStrokes(run); !done)
                return done;
        mFrame.statistics.segments += inView.segments;
        return {};
    }

    Result<void> drawRibbons(const RibbonPlan::Layer &plan)
    {
        const Result<const Program *> program = mFrame.programs.ribbons(isPeeling);
        if (!program)
            return program.error();
        use(**program);
        const auto &colour = mLayer.properties.colour;
        const Eigen::Vector3f shown =
            inBlendSpace(mFrame.painting.blendSpace(), colour.value_or(Eigen::Vector3f::Zero()));
        glUniform4f((*program)->at("ribbonColour"), shown[0], shown[1], shown[2], colour ? 1.f : 0.f);
        glBindVertexArray(mFrame.painting.ribbons().array());
        const GlBuffer widenings = GlBuffer::create(), commands = GlBuffer::create();
        glBindBuffer(GL_ARRAY_BUFFER, widenings.name());
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(plan.widenings.size() * sizeof(float)),
                     plan.widenings.data(), GL_STREAM_DRAW);
        glEnableVertexAttribArray(5);
        glVertexAttribDivisor(5, 1);
        glVertexAttribPointer(5, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands.name());
        glBufferData(GL_DRAW_INDIRECT_BUFFER, GLsizeiptr(plan.commands.size() * sizeof(StripCommand)),
                     plan.commands.data(), GL_STREAM_DRAW);
        glDisable(GL_CULL_FACE);
        glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr, GLsizei(plan.commands.size()), 0);
        ++mFrame.statistics.draws;
        mFrame.statistics.ribbonVertices += plan.vertices;
        return {};
    }

    StrokeInk ink;
    bool isPeeling = false;
    int peel = 0;

private:
    Result<void> drawStrokes(const DrawingRun &run)
    {
        const bool oneSection = std::has_single_bit(mLayer.sections);
        const Result<const Program *> program =
            mFrame.programs.segments({mPass, mReach, oneSection ? std::countr_zero(mLayer.sections) : -1,
                                      mLayer.uniformColour && mPass != Pass::Coverage,
                                      mLayer.uniformOpacity && mPass != Pass::Coverage, isPeeling});
        if (!program)
            return program.error();
        use(**program);
        setLayerColour(**program, mLayer);
        glBindVertexArray(mFrame.painting.segmentArray(run.coarse, mReach == Reach::Surface));
        // Their back faces: there is one for each pixel of a box, whether the eye is inside or not.
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT);
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT,
                                    reinterpret_cast<const void *>(run.firstCommand * sizeof(DrawCommand)),
                                    GLsizei(run.commandCount), 0);
        ++mFrame.statistics.draws;
        return {};
    }

    Result<void> drawMesh(const DrawingRun &run)
    {
        if (mPass == Pass::Substrate)
            return drawMeshSurface(*run.mesh);
        if (Result<void> done = drawMeshInside(run); !done)
            return done;
        return mReach == Reach::Inside ? Result<void>() : drawMeshSurroundings(*run.mesh);
    }

    Result<void> drawMeshSurface(const DrawnElement &mesh)
    {
        const Result<const Program *> program = mFrame.programs.meshSubstrate(isPeeling);
        if (!program)
            return program.error();
        use(**program);
        setLayerColour(**program, mLayer);
        drawTriangles(mesh);
        return {};
    }

    Result<void> drawMeshInside(const DrawingRun &run)
    {
        const Result<const Program *> count = mFrame.programs.meshWinding();
        const Result<const Program *> cover = mFrame.programs.meshCover(mPass == Pass::Coverage);
        if (!count)
            return count.error();
        if (!cover)
            return cover.error();
        GLint target = 0;
        std::array<GLint, 4> scissor{};
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
        glGetIntegerv(GL_SCISSOR_BOX, scissor.data());
        const PixelRect rect =
            run.rect.cutBy({scissor[0], scissor[1], scissor[0] + scissor[2], scissor[1] + scissor[3]});
        if (rect.isEmpty())
            return {};

        mFrame.setScissor(rect);
        mFrame.bindTarget(mFrame.buffers.windingTarget);
        constexpr std::array<float, 4> none{};
        glClearBufferfv(GL_COLOR, 0, none.data());
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        use(**count);
        drawTriangles(*run.mesh);

        glBindFramebuffer(GL_FRAMEBUFFER, GLuint(target));
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        if (mPass == Pass::Appearance)
            glEnable(GL_DEPTH_TEST);
        mFrame.buffers.bind(1, mFrame.buffers.winding);
        use(**cover);
        setMeshColour(**cover, *run.mesh);
        glUniform1ui((*cover)->at("order"), mFrame.painting.orderOf(*run.mesh));
        mFrame.drawWholeFrame();
        glScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
        return {};
    }

    Result<void> drawMeshSurroundings(const DrawnElement &mesh)
    {
        const Result<const Program *> program = mFrame.programs.meshNear(mReach, mPass == Pass::Coverage);
        if (!program)
            return program.error();
        use(**program);
        setMeshColour(**program, mesh);
        glBindVertexArray(mFrame.painting.triangleArray());
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT);
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, boxIndexCount, GL_UNSIGNED_SHORT, nullptr,
                                            GLsizei(mesh.range.count), mesh.range.first);
        ++mFrame.statistics.draws;
        return {};
    }

    void drawTriangles(const DrawnElement &mesh)
    {
        glBindVertexArray(mFrame.painting.meshArray());
        glDisable(GL_CULL_FACE);
        glDrawArrays(GL_TRIANGLES, GLint(3 * mesh.range.first), GLsizei(3 * mesh.range.count));
        ++mFrame.statistics.draws;
    }

    void setMeshColour(const Program &program, const DrawnElement &mesh) const
    {
        const Eigen::Vector3f colour =
            inBlendSpace(mFrame.painting.blendSpace(), mLayer.properties.colour.value_or(mesh.meanColour));
        glUniform4f(program.at("colour"), colour[0], colour[1], colour[2], 1);
    }

    void use(const Program &program) const
    {
        program.use();
        glUniform1f(program.at("tolerance"), mPass == Pass::Substrate ? 0.f : float(mLayer.tolerance));
        glUniform1f(program.at("layerOpacity"), float(mLayer.properties.opacity));
        glUniform1ui(program.at("onlyStack"), GLuint(mOnlyStack.value));
        glUniform1ui(program.at("orderBase"), mFrame.orderBase);
        glUniform1i(program.at("peelCount"), peel);
        glUniform1ui(program.at("orderStep"), ink.onlyFirst ? 0 : 1);
        glUniform1f(program.at("share"), float(ink.share));
    }

    FrameContext &mFrame;
    const DrawnLayer &mLayer;
    Pass mPass;
    StackId mOnlyStack;
    Reach mReach;
};

} // namespace

Result<void> drawSubstrate(FrameContext &frame, const DrawnLayer &layer, int peel, bool peeling)
{
    ElementDrawing drawing(frame, layer, Pass::Substrate, StackId{0});
    drawing.peel = peel;
    drawing.isPeeling = peeling;
    const RibbonPlan::Layer *ribbons = frame.ribbons.of(layer);
    const LayerInView exact = frame.lookAt(layer, {0, true, false, ribbons ? &ribbons->isDrawn : nullptr});
    if (Result<void> done = drawing.draw(exact); !done || !ribbons)
        return done;
    return drawing.drawRibbons(*ribbons);
}

Result<void> drawAppearance(FrameContext &frame, const DrawnLayer &layer, const LayerInView &inView,
                            StackId onlyStack, const StrokeInk &ink)
{
    ElementDrawing drawing(frame, layer, Pass::Appearance, onlyStack);
    drawing.ink = ink;
    return drawing.draw(inView);
}

Result<void> drawCoverage(FrameContext &frame, const DrawnLayer &layer, const LayerInView &inView,
                          StackId onlyStack)
{
    return ElementDrawing(frame, layer, Pass::Coverage, onlyStack).draw(inView);
}

LayerInView lookAtAppearance(const FrameContext &frame, const DrawnLayer &layer, bool isBackwards)
{
    // Directions of reach are known for all points only.
    return frame.lookAt(layer, {reachMargin(frame, layer), reachOf(layer) != Reach::Surface, isBackwards});
}

double reachMargin(const FrameContext &frame, const DrawnLayer &layer)
{
    if (reachOf(layer) != Reach::View)
        return layer.tolerance;
    // Along rays, which are longer than their depth away from the middle of the view.
    const FrameCamera &c = frame.camera;
    return layer.tolerance *
           Vec3(std::max(std::abs(c.left), std::abs(c.right)), std::max(std::abs(c.down), std::abs(c.up)), 1)
               .norm();
}

} // namespace ductus
