#include "doodling/tracking/thing_patch.h"

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
    Shot shot;
    shot.width = shot.clipWidth = width;
    shot.height = shot.clipHeight = height;
    shot.cameras.assign(frames, ShotCamera{});
    for (int t = 0; t < frames; ++t) {
        Image image(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto grey = std::uint8_t(x % 24 < 12 ? 40 : 200);
                image.set(x, y, isSquare(t, x, y) ? Rgba{220, 120, 20, 255} : Rgba{grey, grey, grey, 255});
            }
        shot.pictures.push_back(smallPictureOf(image));
        if (t + 1 == frames)
            break;
        FlowField ahead{width / 4, height / 4, 4.0, {}, {}}, back = ahead;
        for (int i = 0; i < ahead.width * ahead.height; ++i) {
            const double x = 4.0 * (i % ahead.width) + 2.0, y = 4.0 * (i / ahead.width) + 2.0;
            const float told = standsStill ? 0.0f : float(speed);
            ahead.motions.emplace_back(isSquare(t, x, y) ? told : 0.0f, 0.0f);
            back.motions.emplace_back(isSquare(t + 1, x, y) ? -told : 0.0f, 0.0f);
        }
        ahead.confidences.assign(ahead.motions.size(), 1.0f);
        back.confidences = ahead.confidences;
        shot.forward.push_back(ahead);
        shot.backward.push_back(back);
    }
    return shot;
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
