#include "painting/reference/reference_frame.h"

#include "painting/scene/painting_check.h"
#include "support/painting_prober.h"

#include <QtTest>
#include <atomic>
#include <set>

using namespace ductus;
using Eigen::Vector3d;

class ReferenceFrameTest : public QObject
{
    Q_OBJECT
private slots:
    void scenesKeepTheInvariants();
    void mirroredHalvesAreMirrorImages();
    void hiddenLayersChangeNothing();
    void twoHundredStacksKeepApart();
    void looksAndMotion();
    void backgroundAndAlpha();
    void namesTheLayersOfAPoint();
    void refusesAndCancels();
};

void ReferenceFrameTest::scenesKeepTheInvariants()
{
    std::set<std::string> names;
    for (const PaintingScene &scene : allPaintingScenes()) {
        const auto ok = checkPainting(scene.painting);
        QVERIFY2(ok.ok(), (scene.name + (ok ? "" : ok.error().message())).c_str());
        QVERIFY2(names.insert(scene.name).second, scene.name.c_str());
        const ReferenceFrame frame = frameOf(scene, 32);
        QVERIFY2(std::count(frame.stack.begin(), frame.stack.end(), -1) < 32 * 24 * 9 / 10,
                 scene.name.c_str());
    }
}

void ReferenceFrameTest::mirroredHalvesAreMirrorImages()
{
    const ReferenceFrame frame = frameOf(mirroredElements());
    const int width = frame.colour.width, height = frame.colour.height;
    int different = 0, coloured = 0;
    std::set<Rgba> colours;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 2; ++x) {
            different += frame.colour.at(x, y) != frame.colour.at(width - 1 - x, y);
            coloured += frame.stack[std::size_t(y * width + x)] >= 0;
            colours.insert(frame.colour.at(x, y));
        }
    QVERIFY(coloured > 1000);
    QVERIFY(colours.size() >= 5); // background, two substrates, under two coats
    QVERIFY2(different <= coloured / 200, qPrintable(QString("%1 of %2").arg(different).arg(coloured)));
}

void ReferenceFrameTest::hiddenLayersChangeNothing()
{
    const ReferenceFrame with = frameOf(hiddenLayers()), without = frameOf(strokeOrder());
    QVERIFY(with.colour.pixels == without.colour.pixels);
    QVERIFY(with.stack == without.stack && with.element == without.element && with.depth == without.depth);
}

void ReferenceFrameTest::twoHundredStacksKeepApart()
{
    const PaintingScene scene = twoHundredStacks();
    const Prober prober(scene);
    for (int i = 0; i < 200; ++i) {
        const Vec3 centre(-0.95 + 0.1 * (i % 20), -0.65 + 0.14 * (i / 20), 0.03);
        const Probe probe = prober.towards(centre);
        QVERIFY(probe.point && probe.point->stack == i);
        QVERIFY(near(probe.colour, encoded(float(i % 20) / 20, float(i / 20) / 10, 0.5f)));
    }
}

void ReferenceFrameTest::looksAndMotion()
{
    QVERIFY(frameOf(dayAndNight(false)).colour.pixels == frameOf(sceneStack()).colour.pixels);
    QVERIFY(frameOf(dayAndNight(true)).colour.pixels != frameOf(sceneStack()).colour.pixels);

    const PaintingScene start = planeAndShadow(0), later = planeAndShadow(1.5);
    const Prober before(start), after(later);
    const Vec3 body(-0.6, 0.0, 0.46), shadow(-0.45, 0, 0);
    const double t = 0.75;
    Placement moved;
    moved.rotation = Eigen::AngleAxisd(0.4 * t, Vec3::UnitZ());
    moved.translation = t * Vec3(1.1, 0.2, 0);
    QVERIFY(near(before.towards(body).colour, red));
    QVERIFY(near(after.towards(moved.matrix() * body).colour, red));
    QVERIFY(!near(after.towards(body).colour, red));
    const auto onPlate = [](const Prober &prober, const Vec3 &p) { // from close above
        std::vector<SubstratePoint> points;
        prober.solid.surfaces(p + Vec3(0, 0, 0.1), {0, 0, -1}, 0, points);
        return prober.solid.colour(points.at(0), nullptr);
    };
    const Vector3d under = onPlate(before, shadow);
    QVERIFY(!near(under, paper));
    QVERIFY(near(onPlate(after, moved.matrix() * shadow), under)); // the shadow goes with the plane
    QVERIFY(near(onPlate(after, shadow), paper));
    QVERIFY(near(before.towards({0.6, 0.4, 0.32}).colour, paper));
    PaintingScene round = planeAndShadow(5.5); // looped after 4 seconds
    QVERIFY(frameOf(round).colour.pixels == frameOf(later).colour.pixels);
}

void ReferenceFrameTest::backgroundAndAlpha()
{
    PaintingScene scene = selfOverlap();
    scene.painting.background = {0.2f, 0.4f, 0.6f};
    ReferenceOptions options;
    options.width = 64;
    options.height = 48;
    options.samplesPerAxis = 4;
    const ReferenceFrame solid = *referenceFrame(scene.painting, scene.camera, options, {});
    const Vector3d back = 255 * encoded(0.2f, 0.4f, 0.6f);
    QCOMPARE(solid.colour.at(0, 0),
             (Rgba{std::uint8_t(std::lround(back[0])), std::uint8_t(std::lround(back[1])),
                   std::uint8_t(std::lround(back[2])), 255}));
    QVERIFY(std::isinf(solid.depth[0]) && solid.stack[0] == -1 && solid.element[0] == -1);
    options.transparentBackground = true;
    const ReferenceFrame clear = *referenceFrame(scene.painting, scene.camera, options, {});
    std::set<int> alphas;
    for (std::size_t i = 3; i < clear.colour.pixels.size(); i += 4)
        alphas.insert(clear.colour.pixels[i]);
    QVERIFY(alphas.contains(0) && alphas.contains(255) && alphas.size() >= 3); // soft edges
    const std::size_t middle = std::size_t(24 * 64 + 10);
    QVERIFY(std::abs(clear.depth[middle] - 2.6) < 1e-5); // along the view axis, not the ray
}

void ReferenceFrameTest::namesTheLayersOfAPoint()
{
    const PaintingScene scene = sceneStack();
    const Prober prober(scene);
    for (double x = -0.5; x <= 0.5; x += 0.02) {
        const Probe probe = prober.towards({x, 0.1, 0.2});
        if (!probe.point || probe.point->stack != 0)
            continue;
        const auto layers = prober.solid.coloursAt(*probe.point, nullptr);
        if (layers.size() < 2)
            continue;
        QCOMPARE(layers[0].layer, scene.painting.sceneStack.appearance[0].id); // topmost first
        QCOMPARE(layers[1].layer, scene.painting.stacks[0].appearance[0].id);
        QCOMPARE(layers[1].elements.size(), std::size_t(1));
        QVERIFY(near(layers[0].result, probe.colour));
        QVERIFY(near(layers[1].result, blue));
        return;
    }
    QFAIL("no point is coloured by both");
}

void ReferenceFrameTest::refusesAndCancels()
{
    const PaintingScene scene = strokeOrder();
    ReferenceOptions options;
    options.width = 0;
    QCOMPARE(referenceFrame(scene.painting, scene.camera, options, {}).error().code,
             ErrorCode::InvalidArgument);
    options.width = 64;
    options.samplesPerAxis = 9;
    QCOMPARE(referenceFrame(scene.painting, scene.camera, options, {}).error().code,
             ErrorCode::InvalidArgument);
    options.samplesPerAxis = 1;
    FrameCamera camera = scene.camera;
    camera.eye.x() = std::nan("");
    QCOMPARE(referenceFrame(scene.painting, camera, options, {}).error().code, ErrorCode::InvalidArgument);
    options.moment.look = LookId{77};
    QCOMPARE(referenceFrame(scene.painting, scene.camera, options, {}).error().code,
             ErrorCode::InvalidArgument);
    options.moment.look.reset();
    const std::atomic<bool> cancelled{true};
    QVERIFY(referenceFrame(scene.painting, scene.camera, options, JobControl(&cancelled, {}))
                .error()
                .isCancelled());
    const ReferenceFrame nothing = *referenceFrame(Painting(), scene.camera, options, {});
    QCOMPARE(nothing.colour.at(3, 3), (Rgba{255, 255, 255, 255}));
}

QTEST_APPLESS_MAIN(ReferenceFrameTest)
#include "reference_frame_test.moc"
