#include "doodling/tracking/thing_patch.h"

#include "support/clip_thing.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int width = 160, height = 96, frames = 12, speed = 4;

// An orange square moves over stripes; its left edge is at 40 in the first frame.
bool isSquare(int t, double x, double y)
{
    return x >= 40 + speed * t && x < 80 + speed * t && y >= 24 && y < 72;
}

Shot squareShot(bool standsStill)
{
    return madeShot({width, height, frames, isSquare,
                     [](int t, int x, int y) {
                         const auto grey = std::uint8_t(x % 24 < 12 ? 40 : 200);
                         return isSquare(t, x, y) ? Rgba{220, 120, 20, 255} : Rgba{grey, grey, grey, 255};
                     },
                     [=](int) { return standsStill ? 0.0f : float(speed); }});
}

// Near the left edge: the places to the left of it show the stripes.
Vec2 edge(int t)
{
    return {46.0 + speed * t, 48.0};
}

double differenceLater(const Shot &shot, int t)
{
    const Patch patch = thingPatchAt(shot, {0, edge(0)});
    return differenceAt(shot.pictures[std::size_t(t)], edge(t), patch);
}

} // namespace

class ThingPatchTest : public QObject
{
    Q_OBJECT
private slots:
    void whatIsBehindCountsLittle()
    {
        const Shot moving = squareShot(false);
        const Patch patch = thingPatchAt(moving, {0, edge(0)});
        const Patch plain = patchAt(moving.pictures[0], edge(0));
        for (std::size_t i = 0; i < Patch::count; ++i) {
            const Vec2 pixel = edge(0) + Patch::offsetOf(i);
            if (pixel.x() < 36.0)
                QVERIFY(patch.weights[i] < 0.2f * plain.weights[i]);
            if (pixel.x() > 44.0)
                QVERIFY(patch.weights[i] > 0.9f * plain.weights[i]);
        }
    }
    void theThingLooksTheSameBeforeSomethingElse()
    {
        // After three frames the square's edge is over stripes of the other grey.
        QVERIFY(differenceLater(squareShot(false), 3) < 0.5 * differenceLater(squareShot(true), 3));
        QVERIFY(differenceLater(squareShot(true), 3) > 3.0);
    }
    void theFirstAndTheLastFrameHaveOne()
    {
        const Shot shot = squareShot(false);
        for (int t : {0, frames - 1})
            QVERIFY(differenceAt(shot.pictures[std::size_t(t)], edge(t), thingPatchAt(shot, {t, edge(t)})) <
                    1e-3);
    }
};

QTEST_APPLESS_MAIN(ThingPatchTest)
#include "thing_patch_test.moc"
