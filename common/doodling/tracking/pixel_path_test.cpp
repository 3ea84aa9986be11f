#include "doodling/tracking/pixel_path.h"

#include "support/clip_thing.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int frames = 30, speed = 3, width = 320, height = 160;

Rgba groundAt(int x, int y)
{
    const auto grey = std::uint8_t(110 + 40 * std::sin(0.11 * x) * std::cos(0.13 * y));
    return {grey, grey, grey, 255};
}

// An orange ball that moves by 3 pixels a frame over a grey ground; the flow of ten frames missed it and
// says that all stands still, both ways, more or less sure of that: what follows flow alone is left behind on
// the ground.
Shot ballShot(float confidenceOfMiss = 1.0f)
{
    const auto isBall = [](int t, double x, double y) {
        return (Vec2(x, y) - Vec2(60.0 + speed * t, 80.0)).norm() < 26.0;
    };
    const auto isMissed = [](int t) { return t >= 7 && t < 17; };
    return madeShot({width, height, frames, isBall,
                     [=](int t, int x, int y) {
                         return isBall(t, x, y)
                                    ? Rgba{220, std::uint8_t(120 + 2 * int(x - speed * t - 60) + (y - 80)),
                                           20, 255}
                                    : groundAt(x, y);
                     },
                     [=](int t) { return isMissed(t) ? 0.0f : float(speed); },
                     [=](int t) { return isMissed(t) ? confidenceOfMiss : 1.0f; }});
}

Vec2 truth(int t)
{
    return {60.0 + speed * t, 80.0};
}

} // namespace

class PixelPathTest : public QObject
{
    Q_OBJECT
private slots:
    void whatTheFlowLostIsSaidToBeHidden()
    {
        const std::vector<PathPoint> path = pixelPath(ballShot(), {0, truth(0)}, {}, frames - 1, {});
        QCOMPARE(int(path.size()), frames);
        QCOMPARE(path.front().pixel, truth(0));
        for (int t = 0; t <= 7; ++t)
            QVERIFY((path[std::size_t(t)].pixel - truth(t)).norm() < 1.0);
        for (int t = 17; t < frames; ++t) // the ball left it behind by more than its radius
            QVERIFY(!path[std::size_t(t)].isVisible);
    }
    void bothKeyframesAreMet_data()
    {
        QTest::addColumn<bool>("isBackward");
        QTest::addColumn<double>("confidenceOfMiss");
        QTest::addColumn<double>("most"); // pixels
        // What was missed, 30 pixels, is spread over the way, mostly where the flow was unsure.
        QTest::newRow("ahead") << false << 0.1 << 8.0;
        QTest::newRow("back") << true << 0.1 << 8.0;
        QTest::newRow("ahead, flow is sure") << false << 1.0 << 15.0;
        QTest::newRow("back, flow is sure") << true << 1.0 << 15.0;
    }
    void bothKeyframesAreMet()
    {
        QFETCH(bool, isBackward);
        QFETCH(double, confidenceOfMiss);
        QFETCH(double, most);
        PixelKeyframe a{0, truth(0)}, b{frames - 1, truth(frames - 1)};
        if (isBackward)
            std::swap(a, b);
        const std::vector<PathPoint> path = pixelPath(ballShot(float(confidenceOfMiss)), a, b, 0, {});
        QCOMPARE(path.front().pixel, a.pixel);
        QCOMPARE(path.back().pixel, b.pixel);
        for (int i = 0; i < frames; ++i) {
            const int t = isBackward ? frames - 1 - i : i;
            if (t <= 7 || t >= 17)
                QVERIFY((path[std::size_t(i)].pixel - truth(t)).norm() < most);
        }
    }
    void aSingleFrameIsAPath()
    {
        const std::vector<PathPoint> path = pixelPath(ballShot(), {7, truth(7)}, {}, 7, {});
        QCOMPARE(int(path.size()), 1);
        QCOMPARE(path.front().pixel, truth(7));
    }
};

QTEST_APPLESS_MAIN(PixelPathTest)
#include "pixel_path_test.moc"
