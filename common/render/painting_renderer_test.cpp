#include "render/painting_renderer.h"

#include "render/gl/gl_object.h"
#include "render/gl/offscreen_context.h"
#include "support/painting_scenes.h"

#include <QtTest>
#include <optional>

using namespace ductus;

class PaintingRendererTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void recolouringSendsNoGeometry();
    void aMovedStrokeSendsItsPlacement();
    void aNewShapeIsSentAlone();
    void hiddenLayersAreNotSentAgain();
    void removedStrokesMakeRoom();
    void twoViewsAreTwoFrames();
    void whatIsOutsideTheViewIsNotDrawn();
    void farStrokesCostLess();
    void whatOthersLeaveDoesNotMatter();
    void refusals();
    void frameAfterFrameIsTheSame();

private:
    PaintingRenderer make() { return std::move(*PaintingRenderer::create({})); }
    std::optional<OffscreenContext> mContext;
};

namespace {

/// A painting of two layers of \a count strokes each.
Painting manyStrokes(int count)
{
    PaintingBuilder builder;
    const int stack = builder.addStack("ground");
    builder.addLayer(stack, "colour");
    for (int i = 0; i < count; ++i) {
        const float x = 0.05f * float(i % 50), y = 0.05f * float(i / 50);
        for (Layer *layer : {&builder.substrate(stack), &builder.painting.stacks[0].appearance[0]})
            builder.add(*layer, evenStroke(StrokeSection::Round,
                                           {{x, y, 0}, {x + 0.1f, y, 0}, {x + 0.1f, y + 0.1f, 0}}, 0.03f,
                                           {0.2f, 0.4f, 0.6f}));
    }
    return builder.painting;
}

FrameCamera camera()
{
    return FrameCamera::lookingAt(Vec3(1, 0.3, 3), Vec3(1, 0.3, 0), 45, 1);
}

} // namespace

void PaintingRendererTest::initTestCase()
{
    Result<OffscreenContext> context = OffscreenContext::create();
    QVERIFY2(context.ok(), context.ok() ? "" : context.error().message().c_str());
    mContext = std::move(*context);
}

void PaintingRendererTest::recolouringSendsNoGeometry()
{
    Painting painting = manyStrokes(1000); // 2000 strokes
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(painting, {}).ok());
    const Result<Image> before = renderer.image(camera(), 64, 64);
    const RenderStatistics sent = renderer.statistics();
    QVERIFY(sent.geometryBytes >= 2000u * 2 * 84);
    QCOMPARE(sent.elementBytes, 2000u * 64u);

    painting.stacks[0].appearance[0].properties.colour = Eigen::Vector3f(1, 0, 0);
    painting.stacks[0].appearance[0].properties.opacity = 0.5;
    painting.stacks[0].appearance[0].properties.blendMode = BlendMode::Overlay;
    QVERIFY(renderer.update(painting, {}).ok());
    const Result<Image> after = renderer.image(camera(), 64, 64);
    QVERIFY(before.ok() && after.ok());
    QVERIFY(before->pixels != after->pixels);
    QCOMPARE(renderer.statistics().geometryBytes, sent.geometryBytes);
    QCOMPARE(renderer.statistics().elementBytes, sent.elementBytes);
}

void PaintingRendererTest::aMovedStrokeSendsItsPlacement()
{
    Painting painting = manyStrokes(100);
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(painting, {}).ok());
    const RenderStatistics sent = renderer.statistics();
    painting.stacks[0].substrate->drawings[0].elements[40].placement.translation.z() = 0.5;
    QVERIFY(renderer.update(painting, {}).ok());
    QCOMPARE(renderer.statistics().geometryBytes, sent.geometryBytes);
    QCOMPARE(renderer.statistics().elementBytes, sent.elementBytes + 64);
}

void PaintingRendererTest::aNewShapeIsSentAlone()
{
    Painting painting = manyStrokes(100);
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(painting, {}).ok());
    const RenderStatistics sent = renderer.statistics();
    Element &element = painting.stacks[0].appearance[0].drawings[0].elements[7];
    StrokeShape longer = std::get<StrokeShape>(*element.shape);
    longer.points.push_back(longer.points.back());
    longer.points.back().position.x() += 0.1f;
    element.shape = std::make_shared<const ElementShape>(longer);
    QVERIFY(renderer.update(painting, {}).ok());
    const std::uint64_t bytes = renderer.statistics().geometryBytes - sent.geometryBytes;
    QVERIFY2(bytes > 0 && bytes <= 4 * 84, qPrintable(QString::number(bytes)));
}

void PaintingRendererTest::hiddenLayersAreNotSentAgain()
{
    Painting painting = manyStrokes(100);
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(painting, {}).ok());
    const Result<Image> before = renderer.image(camera(), 64, 64);
    const RenderStatistics sent = renderer.statistics();
    painting.stacks[0].appearance[0].properties.visible = false;
    QVERIFY(renderer.update(painting, {}).ok());
    QVERIFY(renderer.image(camera(), 64, 64).ok());
    QCOMPARE(renderer.statistics().segments, sent.segments / 2);
    painting.stacks[0].appearance[0].properties.visible = true;
    QVERIFY(renderer.update(painting, {}).ok());
    QCOMPARE(renderer.statistics().geometryBytes, sent.geometryBytes);
    QCOMPARE(renderer.statistics().elementBytes, sent.elementBytes);
    const Result<Image> after = renderer.image(camera(), 64, 64);
    QCOMPARE(after->pixels, before->pixels);
}

void PaintingRendererTest::removedStrokesMakeRoom()
{
    // What comes and goes a thousand times must neither pile up nor tread on what stays.
    Painting painting = manyStrokes(50);
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(painting, {}).ok());
    const Result<Image> before = renderer.image(camera(), 64, 64);
    const std::vector<Element> all = painting.stacks[0].substrate->drawings[0].elements;
    for (int i = 0; i < 100; ++i) {
        std::vector<Element> &elements = painting.stacks[0].substrate->drawings[0].elements;
        elements.erase(elements.begin() + i % 40, elements.begin() + i % 40 + 10);
        QVERIFY(renderer.update(painting, {}).ok());
        elements = all;
        QVERIFY(renderer.update(painting, {}).ok());
    }
    const Result<Image> after = renderer.image(camera(), 64, 64);
    QCOMPARE(after->pixels, before->pixels);
}

void PaintingRendererTest::twoViewsAreTwoFrames()
{
    const Painting painting = manyStrokes(500);
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(painting, {}).ok());
    FrameCamera left = camera(), right = camera();
    right.eye.x() += 0.2;
    const Result<Image> leftAlone = renderer.image(left, 48, 48), rightAlone = renderer.image(right, 48, 48);
    QVERIFY(leftAlone.ok() && rightAlone.ok());

    const GlTexture texture = GlTexture::create();
    const GlFramebuffer target = GlFramebuffer::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 96, 48);
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    const std::array<RenderView, 2> views{RenderView{left, target.name(), 0, 0, 48, 48},
                                          RenderView{right, target.name(), 48, 0, 48, 48}};
    QVERIFY(renderer.render(views).ok());
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    Image both(96, 48);
    glReadPixels(0, 0, 96, 48, GL_RGBA, GL_UNSIGNED_BYTE, both.pixels.data());
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) {
            QCOMPARE(both.at(x, 47 - y), leftAlone->at(x, y));
            QCOMPARE(both.at(48 + x, 47 - y), rightAlone->at(x, y));
        }
    const auto picked = renderer.pick(1, 24, 24);
    QVERIFY(picked.ok() && *picked);
    QVERIFY(((*picked)->position - Vec3(1.2, 0.3, 0)).norm() < 0.1);
}

void PaintingRendererTest::whatIsOutsideTheViewIsNotDrawn()
{
    const Painting painting = manyStrokes(500);
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(painting, {}).ok());
    QVERIFY(renderer.image(camera(), 64, 64).ok());
    const std::uint64_t all = renderer.statistics().segments;
    FrameCamera near = FrameCamera::lookingAt(Vec3(0.5, 0.2, 0.3), Vec3(0.5, 0.2, 0), 45, 1);
    QVERIFY(renderer.image(near, 64, 64).ok());
    QVERIFY(renderer.statistics().segments > 0);
    QVERIFY(renderer.statistics().segments < all / 4);
    FrameCamera away = FrameCamera::lookingAt(Vec3(1, 1, 4), Vec3(1, 1, 8), 45, 1);
    const Result<Image> nothing = renderer.image(away, 64, 64);
    QVERIFY(nothing.ok());
    QCOMPARE(renderer.statistics().segments, 0u);
    QCOMPARE(nothing->at(32, 32), (Rgba{255, 255, 255, 255}));
}

void PaintingRendererTest::farStrokesCostLess()
{
    PaintingBuilder builder;
    const int stack = builder.addStack("grass");
    for (int i = 0; i < 40; ++i) {
        std::vector<Eigen::Vector3f> points;
        for (int k = 0; k < 30; ++k)
            points.push_back({0.05f * float(i), 0.03f * float(k), 0.01f * std::sin(0.2f * float(k))});
        builder.add(builder.substrate(stack),
                    evenStroke(StrokeSection::Round, points, 0.02f, {0.1f, 0.5f, 0.1f}));
    }
    RenderOptions coarse;
    coarse.errorPixels = 0.5;
    PaintingRenderer exact = make(), fast = std::move(*PaintingRenderer::create(coarse));
    QVERIFY(exact.update(builder.painting, {}).ok());
    QVERIFY(fast.update(builder.painting, {}).ok());
    const FrameCamera far = FrameCamera::lookingAt(Vec3(1, 0.4, 4), Vec3(1, 0.4, 0), 45, 1);
    const Result<Image> all = exact.image(far, 128, 128), less = fast.image(far, 128, 128);
    QVERIFY(all.ok() && less.ok());
    QVERIFY(fast.statistics().segments * 4 < exact.statistics().segments);
    int off = 0;
    for (std::size_t i = 0; i < all->pixels.size(); i += 4)
        off += all->pixels[i] != less->pixels[i];
    QVERIFY2(off < 128 * 128 / 50, qPrintable(QString::number(off)));
    // Near by both are the same.
    const FrameCamera near = FrameCamera::lookingAt(Vec3(1, 0.4, 0.3), Vec3(1, 0.4, 0), 45, 1);
    QCOMPARE(fast.image(near, 128, 128)->pixels, exact.image(near, 128, 128)->pixels);
}

void PaintingRendererTest::whatOthersLeaveDoesNotMatter()
{
    const PaintingScene scene = meshes();
    PaintingRenderer renderer = make();
    QVERIFY(renderer.update(scene.painting, scene.moment).ok());
    const Result<Image> clean = renderer.image(scene.camera, 80, 60);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, 0xff);
    glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_SCISSOR_TEST);
    glScissor(3, 3, 5, 5);
    const Result<Image> after = renderer.image(scene.camera, 80, 60);
    QVERIFY(clean.ok() && after.ok());
    QCOMPARE(after->pixels, clean->pixels);
}

void PaintingRendererTest::refusals()
{
    const Painting painting = manyStrokes(5);
    PaintingRenderer renderer = make();
    const Result<void> look = renderer.update(painting, {0, LookId{99}});
    QVERIFY(!look && look.error().code == ErrorCode::InvalidArgument);
    QVERIFY(renderer.update(painting, {}).ok());
    for (const int size : {0, -3}) {
        const Result<Image> none = renderer.image(camera(), size, 10);
        QVERIFY(!none && none.error().code == ErrorCode::InvalidArgument);
    }
    const Result<Image> huge = renderer.image(camera(), 100000, 10);
    QVERIFY(!huge && huge.error().code == ErrorCode::TooLarge);
    FrameCamera nowhere = camera();
    nowhere.eye.x() = std::nan("");
    QVERIFY(!renderer.image(nowhere, 10, 10));
    QVERIFY(renderer.image(camera(), 10, 10).ok()); // none of them has broken anything
    const auto outside = renderer.pick(0, 10, 3);
    QVERIFY(outside.ok() && !*outside);
}

void PaintingRendererTest::frameAfterFrameIsTheSame()
{
    // Every kind of pass leaves the state as the next one needs it.
    const std::vector<PaintingScene> scenes{meshes(), masked("stroke-inside"), translucentSubstrates(),
                                            blended(BlendMode::Hue, BlendSpace::Linear), sceneStack()};
    PaintingRenderer renderer = make();
    std::vector<Image> first;
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            QVERIFY(renderer.update(scenes[i].painting, scenes[i].moment).ok());
            const Result<Image> image = renderer.image(scenes[i].camera, 80, 60);
            QVERIFY(image.ok());
            if (round == 0)
                first.push_back(*image);
            else
                QCOMPARE(image->pixels, first[i].pixels);
        }
}

QTEST_APPLESS_MAIN(PaintingRendererTest)
#include "painting_renderer_test.moc"
