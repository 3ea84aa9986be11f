#include "render/painting_renderer.h"

#include "render/gl/gl_error.h"
#include "render/passes/frame_pass.h"
#include "render/passes/view_uniforms.h"

#include <vector>

namespace ductus {

namespace {

constexpr const char *attempted = "Drawing the painting";

void leaveClean()
{
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    for (int unit = 4; unit >= 0; --unit) {
        glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        for (const GLenum target : {GL_TEXTURE_2D, GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_2D_ARRAY,
                                    GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_3D})
            glBindTexture(target, 0);
    }
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_CLAMP);
    glBlendFunc(GL_ONE, GL_ZERO);
    glDepthFunc(GL_LESS);
    glCullFace(GL_BACK);
}

} // namespace

struct PaintingRenderer::Parts
{
    RenderOptions options;
    PaintingUpload painting;
    std::unique_ptr<Programs> programs; // of the blend space and samples in use
    ViewUniforms viewUniforms;
    MaskBlocks blocks;
    GlBuffer commands = GlBuffer::create();
    GlVertexArray nothing = GlVertexArray::create();
    struct View
    {
        FrameBuffers buffers;
        FrameCamera camera;
        bool peeled = false;
    };
    std::vector<View> views; // of the last frame
    FrameStatistics statistics;

    Result<void> prepare(std::size_t view, int width, int height);
    Result<void> drawView(std::size_t index, const RenderView &view);
};

Result<void> PaintingRenderer::Parts::prepare(std::size_t view, int width, int height)
{
    if (views.size() <= view)
        views.resize(view + 1);
    FrameBuffers &buffers = views[view].buffers;
    if (buffers.width() != width || buffers.height() != height || !programs ||
        programs->samples() != buffers.samples()) {
        buffers = {}; // first, so that both need not fit
        Result<FrameBuffers> made = FrameBuffers::create(width, height, options.samples);
        if (!made)
            return made.error();
        buffers = std::move(*made);
    }
    if (!programs || programs->space() != painting.blendSpace() || programs->samples() != buffers.samples())
        programs = std::make_unique<Programs>(painting.blendSpace(), buffers.samples());
    return {};
}

Result<void> PaintingRenderer::Parts::drawView(std::size_t index, const RenderView &view)
{
    if (!view.camera.isValid())
        return Error{ErrorCode::InvalidArgument,
                     attempted,
                     "the camera stands nowhere or sees nothing",
                     "Give a finite place and a field of view",
                     {}};
    if (Result<void> ready = prepare(index, view.width, view.height); !ready)
        return ready;
    views[index].camera = view.camera;
    views[index].peeled = needsPeeling(painting);
    viewUniforms.set(view.camera, view.width, view.height);
    FrameContext frame{
        painting,
        *programs,
        views[index].buffers,
        commands,
        nothing,
        view.camera,
        ScreenFinder(view.camera, view.width, view.height),
        {options.smallestPixels, options.errorPixels, options.ribbonPixels, options.ribbonVertices},
        {},
        0,
        {}};
    Result<RibbonPlan> ribbons = planRibbons(painting, frame.screen, frame.detail);
    if (!ribbons)
        return ribbons.error();
    frame.ribbons = std::move(*ribbons);
    Result<void> done = drawFrame(frame, blocks);
    if (done) {
        glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
        done = presentFrame(frame, options.transparentBackground, view.x, view.y);
    }
    statistics.draws += frame.statistics.draws;
    statistics.segments += frame.statistics.segments;
    statistics.ribbonVertices += frame.statistics.ribbonVertices;
    statistics.peels = std::max(statistics.peels, frame.statistics.peels);
    return done;
}

Result<PaintingRenderer> PaintingRenderer::create(const RenderOptions &options)
{
    if (Result<void> enough = checkGlVersion(attempted); !enough)
        return enough.error();
    auto parts = std::make_unique<Parts>();
    parts->options = options;
    return PaintingRenderer(std::move(parts));
}

PaintingRenderer::PaintingRenderer(std::unique_ptr<Parts> parts) : mParts(std::move(parts)) {}
PaintingRenderer::PaintingRenderer(PaintingRenderer &&) noexcept = default;
PaintingRenderer &PaintingRenderer::operator=(PaintingRenderer &&) noexcept = default;
PaintingRenderer::~PaintingRenderer() = default;

const RenderOptions &PaintingRenderer::options() const
{
    return mParts->options;
}

void PaintingRenderer::setOptions(const RenderOptions &options)
{
    if (options.samples != mParts->options.samples)
        mParts->views.clear();
    mParts->options = options;
}

Result<void> PaintingRenderer::update(const Painting &painting, const PaintingMoment &moment)
{
    Result<void> done = mParts->painting.update(painting, moment);
    leaveClean();
    return done;
}

Result<void> PaintingRenderer::render(std::span<const RenderView> views)
{
    mParts->statistics = {};
    Result<void> done;
    for (std::size_t i = 0; i < views.size() && done; ++i)
        done = mParts->drawView(i, views[i]);
    mParts->blocks.dropUnused();
    leaveClean();
    if (!done)
        return done;
    return checkGl(attempted);
}

Result<Image> PaintingRenderer::image(const FrameCamera &camera, int width, int height)
{
    Image image(std::max(width, 0), std::max(height, 0));
    const GlTexture texture = GlTexture::create();
    const GlFramebuffer target = GlFramebuffer::create();
    // render() refuses sizes that the card cannot do, before anything is drawn here.
    if (width > 0 && height > 0) {
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, target.name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
        while (glGetError() != GL_NO_ERROR) {
        }
    }
    const RenderView view{camera, target.name(), 0, 0, width, height};
    if (Result<void> done = render({&view, 1}); !done)
        return done.error();
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    std::vector<std::uint8_t> rows(image.pixels.size());
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    const std::size_t row = std::size_t(width) * 4;
    for (int y = 0; y < height; ++y)
        std::copy_n(rows.data() + std::size_t(height - 1 - y) * row, row,
                    image.pixels.data() + std::size_t(y) * row);
    if (Result<void> fine = checkGl(attempted); !fine)
        return fine.error();
    return image;
}

Result<std::optional<PickedPoint>> PaintingRenderer::pick(std::size_t view, int x, int y)
{
    if (view >= mParts->views.size())
        return std::optional<PickedPoint>();
    const Parts::View &seen = mParts->views[view];
    const int width = seen.buffers.width(), height = seen.buffers.height();
    if (x < 0 || y < 0 || x >= width || y >= height)
        return std::optional<PickedPoint>();
    const Result<FrameBuffers::Place> place = seen.buffers.placeAt(x, height - 1 - y, seen.peeled);
    if (!place)
        return place.error();
    if (place->stack == 0)
        return std::optional<PickedPoint>();
    const Vec3 ray = seen.camera.ray((x + 0.5) / width, (y + 0.5) / height);
    return std::optional(PickedPoint{StackId{place->stack}, ElementId{place->element},
                                     seen.camera.eye + double(place->depth) * ray, double(place->depth)});
}

std::optional<SeenSurface> PaintingRenderer::seenSurface(std::size_t view) const
{
    if (view >= mParts->views.size() || !mParts->views[view].buffers.surface)
        return std::nullopt;
    const Parts::View &seen = mParts->views[view];
    const GlTexture &surface = seen.peeled ? seen.buffers.firstSurface : seen.buffers.surface;
    return SeenSurface{surface.name(), seen.buffers.samples()};
}

RenderStatistics PaintingRenderer::statistics() const
{
    const UploadedBytes bytes = mParts->painting.uploaded();
    const FrameStatistics &frame = mParts->statistics;
    return {frame.draws, frame.segments, frame.ribbonVertices, bytes.geometry, bytes.elements, bytes.reach};
}

} // namespace ductus
