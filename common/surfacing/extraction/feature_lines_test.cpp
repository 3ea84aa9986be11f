#include "surfacing/extraction/feature_lines.h"

#include "base/random.h"

#include <QtTest>
#include <map>
#include <set>

using namespace ductus;

namespace {

using Lines = std::vector<std::vector<int>>;

Lines linesOf(const std::vector<std::pair<int, int>> &edges, const std::vector<double> &sharpness)
{
    SeamedMesh seamed;
    seamed.seamEdges = edges;
    return featureLines(seamed, sharpness);
}

std::multiset<std::pair<int, int>> edgesOf(const Lines &lines)
{
    std::multiset<std::pair<int, int>> edges;
    for (const std::vector<int> &line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            edges.insert(std::minmax(line[i - 1], line[i]));
    return edges;
}

} // namespace

class FeatureLinesTest : public QObject
{
    Q_OBJECT
private slots:
    void chainsAnOpenLine();
    void closedLineRepeatsItsFirstVertex();
    void endsAtJunctions();
    void smoothSeamsAreNoCreases();
    void coversEverySharpEdgeOnce();
};

void FeatureLinesTest::chainsAnOpenLine()
{
    const Lines lines = linesOf({{3, 1}, {0, 2}, {2, 3}}, std::vector<double>(4, 1.0));
    QCOMPARE(lines.size(), std::size_t(1));
    QVERIFY(lines[0] == (std::vector<int>{0, 2, 3, 1}) || lines[0] == (std::vector<int>{1, 3, 2, 0}));
}

void FeatureLinesTest::closedLineRepeatsItsFirstVertex()
{
    const Lines lines = linesOf({{0, 1}, {2, 1}, {2, 3}, {3, 0}}, std::vector<double>(4, 1.0));
    QCOMPARE(lines.size(), std::size_t(1));
    QCOMPARE(lines[0].size(), std::size_t(5));
    QCOMPARE(lines[0].front(), lines[0].back());
    QCOMPARE(std::set<int>(lines[0].begin(), lines[0].end()).size(), std::size_t(4));
}

void FeatureLinesTest::endsAtJunctions()
{
    // A Y with two edges an arm around vertex 0, and a closed loop that hangs on the end of the first arm.
    const Lines lines = linesOf({{0, 1}, {1, 2}, {0, 3}, {3, 4}, {0, 5}, {5, 6}, {2, 7}, {7, 8}, {8, 2}},
                                std::vector<double>(9, 1.0));
    QCOMPARE(lines.size(), std::size_t(4));
    for (const std::vector<int> &line : lines)
        for (std::size_t i = 1; i + 1 < line.size(); ++i)
            QVERIFY(line[i] != 0 && line[i] != 2);
}

void FeatureLinesTest::smoothSeamsAreNoCreases()
{
    QVERIFY(linesOf({{0, 1}, {1, 2}}, {0.1, 0.2, 0.3}).empty());
    const Lines lines = linesOf({{0, 1}, {1, 2}, {2, 3}}, {1.0, 1.0, 0.0, 1.0});
    QCOMPARE(lines.size(), std::size_t(1));
    QCOMPARE(edgesOf(lines), (std::multiset<std::pair<int, int>>{{0, 1}}));
    QVERIFY(linesOf({}, {}).empty());
}

void FeatureLinesTest::coversEverySharpEdgeOnce()
{
    Random random(6);
    for (int trial = 0; trial < 200; ++trial) {
        std::set<std::pair<int, int>> edges;
        for (int i = 0; i < 40; ++i) {
            const int a = random.index(30), b = random.index(30);
            if (a != b)
                edges.insert(std::minmax(a, b));
        }
        std::vector<double> sharpness;
        for (int v = 0; v < 30; ++v)
            sharpness.push_back(random.uniform() < 0.8 ? 1.0 : 0.0);
        std::multiset<std::pair<int, int>> expected;
        std::map<int, int> degree;
        for (const auto &[a, b] : edges)
            if (sharpness[a] > 0.5 && sharpness[b] > 0.5) {
                expected.insert({a, b});
                ++degree[a];
                ++degree[b];
            }
        const Lines lines = linesOf({edges.begin(), edges.end()}, sharpness);
        QCOMPARE(edgesOf(lines), expected);
        for (const std::vector<int> &line : lines) {
            for (std::size_t i = 1; i + 1 < line.size(); ++i)
                QCOMPARE(degree[line[i]], 2);
            if (line.front() != line.back())
                QVERIFY(degree[line.front()] != 2 && degree[line.back()] != 2);
        }
    }
}

QTEST_APPLESS_MAIN(FeatureLinesTest)
#include "feature_lines_test.moc"
