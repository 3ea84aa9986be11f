#include "layerpainter/vr/draw/eye_painter.h"

#include "layerpainter/vr/draw/eye_camera.h"
#include "layerpainter/vr/draw/overlay.h"
#include "layerpainter/vr/session/eye_images.h"
#include "layerpainter/vr/session/xr_words.h"

namespace ductus {

namespace {

// As the window's: what nobody sees is left out.
constexpr double smallestPixels = 0.5, errorPixels = 0.25;

GlFramebuffer targetOf(const GlTexture &texture, const EyeSize &size)
{
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, size.width, size.height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
    GlFramebuffer target = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return target;
}

} // namespace

struct EyePainter::Parts
{
    explicit Parts(PaintingRenderer made) : renderer(std::move(made)) {}

    PaintingRenderer renderer;
    OverlayRenderer overlay;
    std::vector<EyeSize> sizes;
    std::vector<std::unique_ptr<EyeImages>> images;
    std::vector<GlTexture> between; // where images hold linear light: the frame before it is converted
    std::vector<GlFramebuffer> betweenTargets;
    std::shared_ptr<const Painting> uploaded; // what is on the card
    double uploadedSeconds = 0;
    GlTexture mirror;
    GlFramebuffer mirrorTarget;

    void makeTextures();
    Result<void> drawOnto(const std::vector<GLuint> &targets, const std::vector<EyeView> &eyes,
                          const Placement &roomFromScene);
};

EyePainter::EyePainter(std::unique_ptr<Parts> parts) : mParts(std::move(parts)) {}
EyePainter::~EyePainter() = default;

std::uint32_t EyePainter::mirror() const
{
    return mParts->mirror.name();
}

int EyePainter::mirrorWidth() const
{
    return mParts->sizes.front().width;
}

int EyePainter::mirrorHeight() const
{
    return mParts->sizes.front().height;
}

Result<std::unique_ptr<EyePainter>> EyePainter::create(const HeadsetRuntime &runtime,
                                                       const HeadsetSession &session)
{
    Result<std::vector<EyeSize>> sizes = recommendedSizes(runtime);
    if (!sizes)
        return sizes.error();
    const Result<std::int64_t> format = chooseFormat(session.handle());
    if (!format)
        return format.error();
    Result<PaintingRenderer> renderer =
        PaintingRenderer::create({sizes->front().samples, false, smallestPixels, errorPixels});
    if (!renderer)
        return renderer.error();
    auto parts = std::make_unique<Parts>(std::move(*renderer));
    parts->sizes = *sizes;
    for (const EyeSize &size : *sizes) {
        Result<std::unique_ptr<EyeImages>> images = EyeImages::create(session.handle(), *format, size);
        if (!images)
            return images.error();
        parts->images.push_back(std::move(*images));
    }
    parts->makeTextures();
    return std::unique_ptr<EyePainter>(new EyePainter(std::move(parts)));
}

void EyePainter::Parts::makeTextures()
{
    mirror = GlTexture::create();
    mirrorTarget = targetOf(mirror, sizes.front());
    if (!images.front()->isLinear())
        return;
    for (const EyeSize &size : sizes) {
        between.push_back(GlTexture::create());
        betweenTargets.push_back(targetOf(between.back(), size));
    }
}

Result<void> EyePainter::Parts::drawOnto(const std::vector<GLuint> &targets, const std::vector<EyeView> &eyes,
                                         const Placement &roomFromScene)
{
    // The colours are encoded already.
    glDisable(GL_FRAMEBUFFER_SRGB);
    std::vector<RenderView> views;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const GLuint target = between.empty() ? targets[i] : betweenTargets[i].name();
        views.push_back({sceneCamera(eyes[i], roomFromScene), target, 0, 0, sizes[i].width, sizes[i].height});
    }
    if (Result<void> drawn = renderer.render(views); !drawn)
        return drawn;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        glViewport(0, 0, sizes[i].width, sizes[i].height);
        glBindFramebuffer(GL_FRAMEBUFFER, views[i].framebuffer);
        overlay.draw(roomCamera(eyes[i]), renderer.seenSurface(i), roomFromScene.scale);
        if (i == 0) {
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, mirrorTarget.name());
            glBlitFramebuffer(0, 0, sizes[0].width, sizes[0].height, 0, 0, sizes[0].width, sizes[0].height,
                              GL_COLOR_BUFFER_BIT, GL_NEAREST);
        }
        if (!between.empty()) {
            glBindFramebuffer(GL_FRAMEBUFFER, targets[i]);
            overlay.convert(between[i].name());
        }
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return {};
}

Result<void> EyePainter::draw(HeadsetSession &session, XrTime display, const std::vector<EyeView> &eyes,
                              std::shared_ptr<const Painting> painting, double seconds,
                              const Placement &roomFromScene, const OverlayShapes &overlay)
{
    if (eyes.size() != mParts->images.size())
        return session.end(display, nullptr); // the head is not tracked
    // Looking what has changed takes its time with tens of thousands of strokes; mostly nothing has.
    Result<void> done;
    if (painting != mParts->uploaded || seconds != mParts->uploadedSeconds) {
        done = mParts->renderer.update(*painting, {seconds, {}});
        mParts->uploaded = done ? painting : nullptr;
        mParts->uploadedSeconds = seconds;
    }
    mParts->overlay.upload(overlay);
    std::vector<GLuint> targets;
    for (const std::unique_ptr<EyeImages> &one : mParts->images) {
        const Result<GLuint> target = one->acquire();
        if (!target)
            return target.error();
        targets.push_back(*target);
    }
    if (done)
        done = mParts->drawOnto(targets, eyes, roomFromScene);
    // Released and ended whatever happened: the headset's software must not be left waiting.
    std::vector<XrCompositionLayerProjectionView> views;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        if (Result<void> released = mParts->images[i]->release(); !released)
            return released;
        auto view = xrStruct<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
        view.pose = eyes[i].pose;
        view.fov = eyes[i].field;
        view.subImage.swapchain = mParts->images[i]->handle();
        view.subImage.imageRect = {{0, 0}, {mParts->sizes[i].width, mParts->sizes[i].height}};
        views.push_back(view);
    }
    auto layer = xrStruct<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
    layer.space = session.room();
    layer.viewCount = std::uint32_t(views.size());
    layer.views = views.data();
    if (Result<void> ended = session.end(display, done ? &layer : nullptr); !ended)
        return ended;
    return done;
}

} // namespace ductus
