#include "render/passes/appearance_pass.h"

#include "render/passes/element_pass.h"

namespace ductus {

namespace {

/// Layers of one frame are told apart by order; beyond this the private depth is cleared. order.glsl
constexpr std::uint32_t mostOrders = 1u << 22;

bool isFixed(BlendMode mode)
{
    return mode == BlendMode::Normal || mode == BlendMode::Multiply || mode == BlendMode::Screen;
}

void setFixedBlending(BlendMode mode)
{
    // Premultiplied colours on an opaque backdrop; alpha stays.
    const GLenum source = mode == BlendMode::Multiply ? GL_DST_COLOR : GL_ONE;
    const GLenum backdrop = mode == BlendMode::Screen ? GL_ONE_MINUS_SRC_COLOR : GL_ONE_MINUS_SRC_ALPHA;
    glEnable(GL_BLEND);
    glBlendFuncSeparate(source, backdrop, GL_ZERO, GL_ONE);
}

Result<void> composite(FrameContext &frame, const DrawnLayer &layer, const PixelRect &rect)
{
    const BlendMode mode = layer.properties.blendMode;
    const bool fixed = isFixed(mode), masked = hasMasks(layer);
    const Result<const Program *> program = frame.programs.composite(mode, !fixed, masked);
    if (!program)
        return program.error();
    frame.bindTarget(frame.buffers.colourTarget);
    frame.setScissor(rect);
    glDisable(GL_DEPTH_TEST);
    if (fixed) {
        setFixedBlending(mode);
    } else {
        glDisable(GL_BLEND);
        frame.buffers.makeReadable(rect.left, rect.bottom, rect.width(), rect.height());
        frame.buffers.bind(2, frame.buffers.backdrop());
    }
    frame.buffers.bind(1, frame.buffers.layer);
    if (masked)
        frame.buffers.bind(3, frame.buffers.mask);
    (*program)->use();
    glUniform1f((*program)->at("opacity"), float(layer.properties.opacity));
    frame.drawWholeFrame();
    return {};
}

/// Clears the part of the bound picture that will be used; all of it where that is quicker.
void clearPicture(const FrameContext &frame, const PixelRect &rect)
{
    // Whole pictures are cleared by a note in their memory, parts by drawing on them.
    const PixelRect whole = frame.whole();
    const bool isSmall = 8.0 * rect.width() * rect.height() < double(whole.width()) * whole.height();
    frame.setScissor(isSmall ? rect : whole);
    constexpr std::array<float, 4> none{};
    glClearBufferfv(GL_COLOR, 0, none.data());
    frame.setScissor(rect);
}

void clearOrdersIfFull(FrameContext &frame, std::uint32_t wanted)
{
    if (frame.orderBase + wanted < mostOrders)
        return;
    constexpr float first = 1;
    frame.setScissor(frame.whole());
    glClearBufferfv(GL_DEPTH, 0, &first);
    frame.orderBase = 0;
}

Result<void> drawLayer(FrameContext &frame, MaskBlocks &blocks, const DrawnLayer &layer,
                       const PixelRect &within, StackId onlyStack)
{
    const WayOfDrawing way = wayOfDrawing(layer);
    // Of one colour it does not matter which stroke is met first.
    const bool isBackwards = way == WayOfDrawing::Topmost && !layer.properties.colour;
    const LayerInView inView = lookAtAppearance(frame, layer, isBackwards);
    const PixelRect rect = inView.rect.cutBy(within);
    if (rect.isEmpty())
        return {};
    const bool hasPicture = way == WayOfDrawing::OwnPicture;
    frame.bindTarget(hasPicture ? frame.buffers.layerTarget : frame.buffers.straightTarget);
    glDepthMask(GL_TRUE);
    clearOrdersIfFull(frame, std::uint32_t(layer.elements.size()));
    if (hasPicture)
        clearPicture(frame, rect);
    frame.setScissor(rect);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    if (hasPicture) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    } else {
        setFixedBlending(layer.properties.blendMode);
    }
    const StrokeInk ink{way == WayOfDrawing::Topmost, hasPicture ? 1.0 : layer.properties.opacity};
    if (Result<void> done = drawAppearance(frame, layer, inView, onlyStack, ink); !done)
        return done;
    frame.orderBase += layer.orderCount;
    if (!hasPicture)
        return {};
    if (hasMasks(layer))
        if (Result<void> done = drawMasks(frame, blocks, layer, rect, onlyStack); !done)
            return done;
    return composite(frame, layer, rect);
}

} // namespace

WayOfDrawing wayOfDrawing(const DrawnLayer &layer)
{
    if (layer.hasMeshes || hasMasks(layer) || !isFixed(layer.properties.blendMode))
        return WayOfDrawing::OwnPicture;
    if (layer.properties.blendMode == BlendMode::Normal && layer.properties.opacity >= 1)
        return WayOfDrawing::Straight;
    return layer.hasClearStrokes ? WayOfDrawing::OwnPicture : WayOfDrawing::Topmost;
}

Result<void> drawAppearances(FrameContext &frame, MaskBlocks &blocks)
{
    frame.orderBase = mostOrders; // the first layer clears
    frame.buffers.bind(0, frame.buffers.surface);
    PixelRect all;
    for (const DrawnStack &stack : frame.painting.stacks()) {
        PixelRect rect;
        for (const DrawnElement &element : stack.substrate.elements)
            rect = rect.with(frame.screen.rect(element.centre, element.radius));
        all = all.with(rect);
        for (const DrawnLayer &layer : stack.appearance)
            if (Result<void> done = drawLayer(frame, blocks, layer, rect, stack.id); !done)
                return done;
    }
    for (const DrawnLayer &layer : frame.painting.sceneLayers())
        if (Result<void> done = drawLayer(frame, blocks, layer, all, sceneStackId); !done)
            return done;
    return {};
}

} // namespace ductus
