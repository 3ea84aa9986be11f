#include "doodling/tracking/follow_pixel.h"

#include "doodling/tracking/motion_between.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int frames = 17, cells = 40;
const Vec2 start(40.0, 50.0);

FlowField evenFlow(const Vec2 &motion, double confidence = 1.0)
{
    return {cells, cells, 4.0, std::vector<Eigen::Vector2f>(cells * cells, motion.cast<float>()),
            std::vector<float>(cells * cells, float(confidence))};
}

// Everything moves by two pixels a frame; the flow between neighbours says \a told instead.
Shot shotTelling(double told, bool hasLongFlows)
{
    Shot shot;
    shot.width = shot.height = shot.clipWidth = shot.clipHeight = 4 * cells;
    shot.cameras.assign(frames, ShotCamera{});
    for (int t = 0; t + 1 < frames; ++t) {
        shot.forward.push_back(evenFlow({told, 0.0}));
        shot.backward.push_back(evenFlow({-told, 0.0}));
    }
    for (int gap : longGaps)
        for (int t = 0; hasLongFlows && t + gap < frames; ++t)
            shot.longFlows[{t, gap}] = {compacted(evenFlow({2.0 * gap, 0.0})),
                                        compacted(evenFlow({-2.0 * gap, 0.0}))};
    return shot;
}

} // namespace

class FollowPixelTest : public QObject
{
    Q_OBJECT
private slots:
    void longStepsGatherLessError()
    {
        const Vec2 there = start + Vec2(2.0 * (frames - 1), 0.0);
        const auto end = [&](bool hasLongFlows) {
            const Shot shot = shotTelling(1.8, hasLongFlows);
            return followPixel(shot, {0, start}, frames - 1, {}, {gapsOf(shot), 0.3, 0.0, 0.0}).back();
        };
        QVERIFY((end(false).pixel - there).norm() > 2.8); // a fifth of a pixel a step, to the flow's 1/32
        QVERIFY((end(true).pixel - there).norm() < 0.5);
        QVERIFY(end(true).variance < end(false).variance);
    }
    void backwardsIsTheSame()
    {
        const Shot shot = shotTelling(2.0, true);
        const auto back =
            followPixel(shot, {frames - 1, start + Vec2(32.0, 0.0)}, 0, {}, {gapsOf(shot), 0.3, 0.0, 0.0});
        QCOMPARE(int(back.size()), frames);
        QVERIFY((back.back().pixel - start).norm() < 0.1);
    }
    void aFlowThatWasLostGoesWhereItIsExpected()
    {
        Shot shot = shotTelling(2.0, false);
        shot.forward[8] = evenFlow({30.0, 30.0}, 0.0);
        std::vector<ExpectedPlace> expected;
        for (int t = 0; t < frames; ++t)
            expected.push_back({start + Vec2(2.0 * t, 1.0), 3.0});
        const auto followed = followPixel(shot, {0, start}, frames - 1, expected, {{1}, 0.3, 0.0, 0.3});
        QVERIFY((followed.back().pixel - expected.back().pixel).norm() < 3.0);
        const auto lost = followPixel(shot, {0, start}, frames - 1, {}, {{1}, 0.3, 0.0, 0.3});
        QVERIFY((lost.back().pixel - expected.back().pixel).norm() > 30.0);
    }
    void staysNearThePicture()
    {
        const Shot shot = shotTelling(40.0, false);
        const auto followed = followPixel(shot, {0, start}, frames - 1, {}, {{1}, 0.3, 0.0, 0.0});
        QVERIFY((followed.back().pixel - keptNear(shot, {1e6, start.y()})).norm() < 1e-6);
        QVERIFY(!isInside(shot, followed.back().pixel));
    }
};

QTEST_APPLESS_MAIN(FollowPixelTest)
#include "follow_pixel_test.moc"
