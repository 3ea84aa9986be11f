#include "doodling/tracking/path_search.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int frames = 24, width = 320, height = 160;
const Vec2 here(80.0, 80.0), there(200.0, 80.0);

// All stands still, and the flow says so; pictures are not asked.
Shot stillShot()
{
    Shot shot;
    shot.width = shot.clipWidth = width;
    shot.height = shot.clipHeight = height;
    shot.cameras.assign(frames, ShotCamera{});
    FlowField still{width / 8, height / 8, 8.0, {}, {}};
    still.motions.assign(std::size_t(still.width * still.height), Eigen::Vector2f::Zero());
    still.confidences.assign(still.motions.size(), 1.0f);
    for (int t = 0; t + 1 < frames; ++t) {
        shot.forward.push_back(still);
        shot.backward.push_back(still);
    }
    return shot;
}

// Each frame proposes the place the flow leads to, and another one that looks just like the keyframe.
PathProposals proposalsWith(double difference, double otherDifference)
{
    PathProposals proposals;
    proposals.frames.push_back({{here, 0.0, 0.0, false}});
    for (int t = 1; t < frames; ++t)
        proposals.frames.push_back({{here, difference, 0.0, false}, {there, otherDifference, 2.0, true}});
    proposals.support.places.assign(frames, {here, 8.0});
    return proposals;
}

} // namespace

class PathSearchTest : public QObject
{
    Q_OBJECT
private slots:
    void whatTurnsIsSeenWhileTheFlowLeadsOn()
    {
        const std::vector<PathPoint> path = bestPath(stillShot(), proposalsWith(26.0, 40.0), 0, 1, false, {});
        for (const PathPoint &point : path) {
            QCOMPARE(point.pixel, here);
            QVERIFY(point.isVisible);
        }
    }
    void whatLooksLikeSomethingElseIsHidden()
    {
        const std::vector<PathPoint> path = bestPath(stillShot(), proposalsWith(38.0, 40.0), 0, 1, false, {});
        QVERIFY(path.front().isVisible);
        for (std::size_t t = 1; t < path.size(); ++t)
            QVERIFY(!path[t].isVisible);
    }
    void whatLooksAlikeFarAwayDoesNotDrawAPointThatIsSeen()
    {
        const std::vector<PathPoint> path = bestPath(stillShot(), proposalsWith(15.0, 0.0), 0, 1, false, {});
        for (const PathPoint &point : path)
            QCOMPARE(point.pixel, here);
    }
};

QTEST_APPLESS_MAIN(PathSearchTest)
#include "path_search_test.moc"
