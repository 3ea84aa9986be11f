// From afar strokes are drawn as cards instead of boxes: they must hide no skin and nothing that is covered.
#include "base/random.h"
#include "painting/reference/reference_frame.h"
#include "render/gl/offscreen_context.h"
#include "render/painting_renderer.h"

#include <QtTest>
#include <numbers>
#include <optional>

using namespace ductus;

class FarStrokesTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void framesAreTheReferences_data();
    void framesAreTheReferences();

private:
    std::optional<OffscreenContext> mContext;
};

namespace {

/// Kinks, steep tapers, bulges and points in the same place.
std::shared_ptr<const ElementShape> wildStroke(Random &random, double wildness, bool isFaint)
{
    StrokeShape shape;
    shape.section = StrokeSection::Round;
    const auto somewhere = [&](double size) {
        return Vec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    };
    Vec3 at = somewhere(0.5), step = somewhere(0.1);
    const Eigen::Vector3f colour(float(random.uniform()), float(random.uniform()), float(random.uniform()));
    for (int i = 0; i < 9; ++i) {
        const double halfWidth = 0.06 * (1 + wildness * random.uniform(-0.9, 0.9));
        const float opacity = isFaint ? float(random.uniform(0.4, 1)) : 1;
        shape.points.push_back(
            {at.cast<float>(), somewhere(1).normalized().cast<float>(), float(halfWidth), colour, opacity});
        step += somewhere(0.1 * wildness);
        if (random.uniform() > 0.1 * wildness)
            at += step;
    }
    return std::make_shared<const ElementShape>(std::move(shape));
}

Painting wildPainting(double wildness, bool isFaint)
{
    Painting painting;
    Random random(11);
    Stack stack;
    stack.id.value = painting.nextId++;
    Layer ground, over;
    ground.id.value = painting.nextId++;
    over.id.value = painting.nextId++;
    over.tolerance = 0.01;
    for (int i = 0; i < 14; ++i)
        ground.drawings[0].elements.push_back(
            {ElementId{painting.nextId++}, {}, wildStroke(random, wildness, false)});
    for (int i = 0; i < 14; ++i)
        over.drawings[0].elements.push_back(
            {ElementId{painting.nextId++}, {}, wildStroke(random, wildness, isFaint)});
    stack.substrate = std::move(ground);
    stack.appearance.push_back(std::move(over));
    painting.stacks.push_back(std::move(stack));
    return painting;
}

} // namespace

void FarStrokesTest::initTestCase()
{
    Result<OffscreenContext> context = OffscreenContext::create();
    QVERIFY2(context.ok(), context.ok() ? "" : context.error().message().c_str());
    mContext = std::move(*context);
}

void FarStrokesTest::framesAreTheReferences_data()
{
    QTest::addColumn<double>("wildness");
    QTest::addColumn<bool>("isFaint");
    QTest::newRow("calm") << 0.1 << false;
    QTest::newRow("bent") << 0.4 << true;
    QTest::newRow("wild") << 1.0 << false;
}

void FarStrokesTest::framesAreTheReferences()
{
    QFETCH(double, wildness);
    QFETCH(bool, isFaint);
    constexpr int side = 200;
    const Painting painting = wildPainting(wildness, isFaint);
    PaintingRenderer renderer = std::move(*PaintingRenderer::create({}));
    QVERIFY(renderer.update(painting, {}).ok());
    ReferenceOptions options;
    options.width = options.height = side;
    for (int view = 0; view < 6; ++view) {
        // Just beyond where cards begin, and with a long lens from far away.
        const double distance = view % 2 == 0 ? 6 : 40, angle = 2 * std::numbers::pi * view / 6;
        const Vec3 from = Vec3(std::cos(angle), view - 2.5, std::sin(angle)).normalized();
        const FrameCamera camera = FrameCamera::lookingAt(
            distance * from, Vec3::Zero(), 2 * std::atan(1.2 / distance) * 180 / std::numbers::pi, 1);
        const Result<Image> image = renderer.image(camera, side, side);
        QVERIFY2(image.ok(), image.ok() ? "" : image.error().message().c_str());
        const Result<ReferenceFrame> reference = referenceFrame(painting, camera, options, JobControl());
        QVERIFY(reference.ok());
        int off = 0, seen = 0;
        for (int i = 0; i < side * side; ++i) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(int(image->pixels[4 * std::size_t(i) + c]) -
                                               int(reference->colour.pixels[4 * std::size_t(i) + c])));
            off += most > 2;
            seen += reference->element[std::size_t(i)] > 0;
        }
        QVERIFY(seen > side * side / 20);
        QVERIFY2(off <= seen / 500,
                 qPrintable(QString("view %1: %2 of %3 pixels are off").arg(view).arg(off).arg(seen)));
    }
}

QTEST_APPLESS_MAIN(FarStrokesTest)
#include "far_strokes_test.moc"
