#include "formats/sketches/segment_chains.h"

#include "base/random.h"

#include <QtTest>
#include <map>

using namespace ductus;

using Chains = std::vector<std::vector<int>>;

class SegmentChainsTest : public QObject
{
    Q_OBJECT
private slots:
    void exportedBackwardsSegmentsRunInFileOrder();
    void aSingleSegmentKeepsItsDirection();
    void aLoopIsClosedAndStartsAtItsFirstSegment();
    void crossingLinesStayWhole();
    void aSideBranchEndsAtTheStraightLine();
    void bentJunctionsEndAllStrokes();
    void fiveArmsEndAllStrokes();
    void randomGraphsUseEachSegmentOnce();
};

void SegmentChainsTest::exportedBackwardsSegmentsRunInFileOrder()
{
    const std::vector<Vec3> line(5, Vec3::Zero());
    QCOMPARE(chainSegments({{1, 0}, {2, 1}, {3, 2}, {4, 3}}, line), (Chains{{0, 1, 2, 3, 4}}));
    QCOMPARE(chainSegments({{0, 1}, {1, 2}, {2, 3}}, line), (Chains{{0, 1, 2, 3}}));
}

void SegmentChainsTest::aSingleSegmentKeepsItsDirection()
{
    const std::vector<Vec3> points(4, Vec3::Zero());
    QCOMPARE(chainSegments({{3, 1}, {0, 2}}, points), (Chains{{3, 1}, {0, 2}}));
    QVERIFY(chainSegments({}, points).empty());
}

void SegmentChainsTest::aLoopIsClosedAndStartsAtItsFirstSegment()
{
    const std::vector<Vec3> points(4, Vec3::Zero());
    QCOMPARE(chainSegments({{1, 0}, {2, 1}, {3, 2}, {3, 0}}, points), (Chains{{0, 1, 2, 3, 0}}));
}

void SegmentChainsTest::crossingLinesStayWhole()
{
    // 0 - 1 - 2 along x, 3 - 1 - 4 along y
    const std::vector<Vec3> points{{-1, 0, 0}, {0, 0, 0}, {1, 0.1, 0}, {0, -1, 0}, {0, 1, 0}};
    QCOMPARE(chainSegments({{0, 1}, {1, 2}, {3, 1}, {1, 4}}, points), (Chains{{0, 1, 2}, {3, 1, 4}}));
}

void SegmentChainsTest::aSideBranchEndsAtTheStraightLine()
{
    const std::vector<Vec3> points{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    QCOMPARE(chainSegments({{0, 1}, {1, 3}, {1, 2}}, points), (Chains{{0, 1, 2}, {1, 3}}));
}

void SegmentChainsTest::bentJunctionsEndAllStrokes()
{
    // Three arms at 120 degrees: none goes on straight.
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {-0.5, 0.87, 0}, {-0.5, -0.87, 0}};
    QCOMPARE(chainSegments({{1, 0}, {0, 2}, {0, 3}}, points), (Chains{{1, 0}, {0, 2}, {0, 3}}));
}

void SegmentChainsTest::fiveArmsEndAllStrokes()
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    QCOMPARE(chainSegments({{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}, points).size(), std::size_t(5));
}

void SegmentChainsTest::randomGraphsUseEachSegmentOnce()
{
    Random random(11);
    for (int run = 0; run < 200; ++run) {
        const int vertexCount = 2 + random.index(12);
        std::vector<Vec3> points;
        for (int v = 0; v < vertexCount; ++v)
            points.emplace_back(random.normal(), random.normal(), random.normal());
        std::vector<Segment> segments;
        std::map<std::pair<int, int>, int> left;
        std::vector<int> degree(std::size_t(vertexCount), 0);
        for (int s = random.index(16); s >= 0; --s) {
            const int a = random.index(vertexCount), b = random.index(vertexCount);
            if (a == b || left.count(std::minmax(a, b)))
                continue;
            segments.push_back({a, b});
            left[std::minmax(a, b)] = 1;
            ++degree[std::size_t(a)];
            ++degree[std::size_t(b)];
        }
        const Chains chains = chainSegments(segments, points);
        QCOMPARE(chainSegments(segments, points), chains);
        for (const auto &chain : chains) {
            QVERIFY(chain.size() >= 2);
            for (std::size_t i = 1; i < chain.size(); ++i)
                QCOMPARE(left[std::minmax(chain[i - 1], chain[i])]--, 1);
            if (chain.front() != chain.back()) {
                QVERIFY(degree[std::size_t(chain.front())] != 2);
                QVERIFY(degree[std::size_t(chain.back())] != 2);
            }
        }
        for (const auto &[edge, count] : left)
            QCOMPARE(count, 0);
    }
}

QTEST_APPLESS_MAIN(SegmentChainsTest)
#include "segment_chains_test.moc"
