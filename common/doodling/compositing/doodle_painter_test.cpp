#include "doodling/compositing/doodle_painter.h"

#include "doodling/canvas/edit_doodle.h"
#include "doodling/canvas/edit_scene.h"
#include "doodling/compositing/occlusion.h"
#include "doodling/compositing/stickers.h"
#include "doodling/compositing/text_outlines.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int width = 160, height = 96, frames = 4;

// Everything at depth 10 but for a near thing in the right half, which is red in the picture and moves 4
// pixels to the right each frame, as the flow says everywhere.
Shot shotOfTwoHalves()
{
    Shot shot;
    shot.width = shot.clipWidth = width;
    shot.height = shot.clipHeight = height;
    ShotCamera camera;
    camera.focal = 160.0;
    camera.centre = Vec2(80.0, 48.0);
    shot.cameras.assign(frames, camera);
    std::vector<float> disparities;
    for (int y = 0; y < height / 4; ++y)
        for (int x = 0; x < width / 4; ++x)
            disparities.push_back(x >= 20 ? 0.5f : 0.1f);
    shot.depths.assign(frames, depthMapOf(width / 4, height / 4, 4.0, disparities));
    const FlowField right{1, 1, 160.0, {Eigen::Vector2f(4.0f, 0.0f)}, {1.0f}};
    const FlowField left{1, 1, 160.0, {Eigen::Vector2f(-4.0f, 0.0f)}, {1.0f}};
    shot.forward.assign(frames - 1, right);
    shot.backward.assign(frames - 1, left);
    return shot;
}

// The thing's edge is at pixel 82, two beside where the depth has it.
Image pictureOfTwoHalves()
{
    Image picture(width, height, {90, 110, 130, 255});
    for (int y = 0; y < height; ++y)
        for (int x = 82; x < width; ++x)
            picture.set(x, y, {200, 60, 40, 255});
    return picture;
}

Canvas sheet(double depth, const Rgba &colour)
{
    Canvas canvas;
    canvas.keyframes.positions = {{0, Vec2(80.0, 48.0), depth, false}};
    const double w = 0.35 * depth, h = 0.2 * depth; // pixels 24..136 by 16..80, whatever the depth
    canvas.doodle = *withMark(canvas.doodle, 0, FilledShape{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}, colour});
    return canvas;
}

Image painted(const DoodleScene &scene, int frame = 0)
{
    const Shot shot = shotOfTwoHalves();
    std::vector<CanvasTrack> tracks;
    for (const Canvas &canvas : scene.canvases)
        tracks.push_back(*canvasTrack(shot, canvas, {}));
    return DoodlePainter().alone({shot, scene, tracks, frame}, pictureOfTwoHalves());
}

DoodleScene sceneOf(std::vector<Canvas> canvases)
{
    DoodleScene scene;
    for (Canvas &canvas : canvases)
        scene = *withCanvas(scene, canvas);
    return scene;
}

constexpr Rgba green = {0, 200, 0, 255}, blue = {0, 0, 200, 255};

} // namespace

class DoodlePainterTest : public QObject
{
    Q_OBJECT
private slots:
    void whatIsNearHidesTheCanvas()
    {
        const Image image = painted(sceneOf({sheet(5.0, green)}));
        QVERIFY(image.at(40, 48) == green);
        QCOMPARE(int(image.at(120, 48)[3]), 0);
        QCOMPARE(int(image.at(10, 48)[3]), 0);
        // The edge is where the picture has it.
        QVERIFY(image.at(79, 48)[3] > 180);
        QVERIFY(image.at(85, 48)[3] < 60);
    }
    void beforeEverythingAllIsSeen()
    {
        const Image image = painted(sceneOf({sheet(1.5, green)}));
        QVERIFY(image.at(40, 48) == green && image.at(120, 48) == green);
        Canvas behind = sheet(5.0, green);
        behind.occlusion.isOn = false;
        QVERIFY(painted(sceneOf({behind})).at(120, 48) == green);
    }
    void nearCanvasesCoverFarOnes()
    {
        QVERIFY(painted(sceneOf({sheet(4.0, green), sheet(5.0, blue)})).at(40, 48) == green);
        QVERIFY(painted(sceneOf({sheet(5.0, green), sheet(5.0, blue)})).at(40, 48) ==
                blue); // the order decides
    }
    void opacityAndVisibility()
    {
        Canvas half = sheet(5.0, green);
        half.opacity = 0.5;
        QVERIFY(std::abs(int(painted(sceneOf({half})).at(40, 48)[3]) - 128) <= 1);
        half.isVisible = false;
        QCOMPARE(int(painted(sceneOf({half})).at(40, 48)[3]), 0);
    }
    void theUsersWordCountsAndMovesAlong()
    {
        Canvas canvas = sheet(5.0, green);
        canvas.occlusion.touches = {{0, {{110.0, 48.0}}, 6.0, true, 3}, {0, {{40.0, 48.0}}, 6.0, false, 0}};
        const Image first = painted(sceneOf({canvas}));
        QVERIFY(first.at(110, 48) == green);
        QCOMPARE(int(first.at(40, 48)[3]), 0);
        QVERIFY(first.at(50, 48) == green);
        const Image second = painted(sceneOf({canvas}), 1);
        QVERIFY(second.at(114, 48) == green); // 4 pixels on
        QCOMPARE(int(second.at(102, 48)[3]), 0);
        QVERIFY(second.at(40, 48) == green); // out of its reach
        const Vec2 back = carriedLine({2, {{50.0, 20.0}}, 6.0, true, 3}, shotOfTwoHalves(), 0)[0];
        QVERIFY((back - Vec2(42.0, 20.0)).norm() < 1e-6);
    }
    void wordsHaveLettersAndAreCentred()
    {
        const TextOutlines fonts;
        const auto outlines = fonts.of("oo\no", true);
        QCOMPARE(int(outlines.size()), 6); // each with its hole
        Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
        for (const auto &outline : outlines)
            for (const Vec2 &point : outline) {
                low = low.cwiseMin(point);
                high = high.cwiseMax(point);
            }
        QVERIFY(std::abs(low.x() + high.x()) < 0.05);
        QVERIFY(low.y() > -1.0 && high.y() < 1.0 && high.y() - low.y() > 1.0);
        QVERIFY(fonts.of("", true).empty());
        QVERIFY(!fonts.of("\xff", true).empty()); // not UTF-8: something is shown
    }
    void everyStickerIsDrawnInItsSquare()
    {
        QVERIFY(stickerNames().size() >= 10);
        for (const std::string_view name : stickerNames()) {
            Doodle doodle =
                *withMark(Doodle(), 0, StickerMark{std::string(name), {0.0, 0.0}, 1.0, 0.0, green});
            const Image image = DoodlePainter().flat(doodle.frames[0], {1.2, 1.2}, 60, 60);
            int seen = 0;
            for (int y = 0; y < 60; ++y)
                for (int x = 0; x < 60; ++x) {
                    const bool isInk = image.at(x, y)[3] > 128;
                    seen += isInk;
                    QVERIFY2(!isInk || (x >= 5 && y >= 5 && x < 55 && y < 55), std::string(name).c_str());
                }
            QVERIFY2(seen > 100, std::string(name).c_str());
        }
    }
};

QTEST_APPLESS_MAIN(DoodlePainterTest)
#include "doodle_painter_test.moc"
