#include "doodling/tracking/layered_path.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

using Layers = std::vector<std::vector<PathCell>>;

Layers randomLayers(std::uint64_t seed, int frames, int cells)
{
    Random random(seed);
    const auto vector = [&](double size) {
        return Vec3(size * random.normal(), size * random.normal(), size * random.normal());
    };
    Layers layers;
    layers.resize(std::size_t(frames));
    for (auto &layer : layers)
        for (int i = 0; i < cells; ++i)
            layer.push_back({vector(1.0), vector(0.3), random.uniform(0.0, 0.5), false});
    return layers;
}

double costOf(const Layers &layers, const std::vector<int> &cells)
{
    double cost = layers[0][std::size_t(cells[0])].cost;
    for (std::size_t t = 1; t < layers.size(); ++t) {
        const PathCell &from = layers[t - 1][std::size_t(cells[t - 1])],
                       &to = layers[t][std::size_t(cells[t])];
        cost +=
            (to.place - from.place - (from.isKeyframed ? Vec3(Vec3::Zero()) : from.motion)).squaredNorm() +
            to.cost;
    }
    return cost;
}

double leastCost(const Layers &layers)
{
    std::vector<int> cells(layers.size(), 0);
    double least = 1e300;
    for (;;) {
        least = std::min(least, costOf(layers, cells));
        std::size_t t = 0;
        while (t < cells.size() && ++cells[t] == int(layers[t].size()))
            cells[t++] = 0;
        if (t == cells.size())
            return least;
    }
}

// One thing moves to the right at 0.1 a frame, a wall of cells stands still before it.
Layers behindAWall(int frames, int hiddenFrom, int hiddenTo)
{
    Layers layers;
    layers.resize(std::size_t(frames));
    for (int t = 0; t < frames; ++t) {
        if (t < hiddenFrom || t >= hiddenTo)
            layers[std::size_t(t)].push_back({Vec3(0.1 * t, 0.0, 5.0), Vec3(0.1, 0.0, 0.0), 0.0, false});
        for (int i = 0; i < 40; ++i)
            layers[std::size_t(t)].push_back({Vec3(0.1 * i, 0.0, 4.0), Vec3::Zero(), 0.0, false});
    }
    layers[0].resize(1);
    layers[0][0].isKeyframed = true;
    return layers;
}

} // namespace

class LayeredPathTest : public QObject
{
    Q_OBJECT
private slots:
    void equalsAllPathsTried();
    void aKeyframedCellGoesByNearness();
    void passesBehindAWall();
    void withoutHidingItStaysInTheCells();
    void hidingIsNotForEver();
    void emptyLayersAreRefused();
    void cancelled();
};

void LayeredPathTest::equalsAllPathsTried()
{
    LayeredPathOptions visible;
    visible.hiddenPoints = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Layers layers = randomLayers(seed, 6, 5);
        if (seed % 2)
            for (PathCell &cell : layers[2])
                cell.isKeyframed = true;
        const auto path = shortestPath(layers, visible, {});
        QVERIFY(path.ok());
        QVERIFY(std::abs(path->cost - leastCost(layers)) < 1e-9);
        QVERIFY(std::abs(path->cost - costOf(layers, path->cells)) < 1e-9);
        for (std::size_t t = 0; t < layers.size(); ++t)
            QCOMPARE(path->places[t], layers[t][std::size_t(path->cells[t])].place);
    }
}

void LayeredPathTest::aKeyframedCellGoesByNearness()
{
    Layers layers{
        {{Vec3::Zero(), Vec3(5.0, 0.0, 0.0), 0.0, true}},
        {{Vec3(5.0, 0.0, 0.0), Vec3::Zero(), 0.0, false}, {Vec3(0.1, 0.0, 0.0), Vec3::Zero(), 0.0, false}}};
    QCOMPARE(shortestPath(layers, {}, {})->cells, (std::vector<int>{0, 1}));
    layers[0][0].isKeyframed = false;
    QCOMPARE(shortestPath(layers, {}, {})->cells, (std::vector<int>{0, 0}));
}

void LayeredPathTest::passesBehindAWall()
{
    const Layers layers = behindAWall(30, 10, 18);
    const auto path = shortestPath(layers, {}, {});
    QVERIFY(path.ok());
    for (int t = 0; t < 30; ++t) {
        QCOMPARE(path->cells[std::size_t(t)], t >= 10 && t < 18 ? -1 : 0);
        QVERIFY((path->places[std::size_t(t)] - Vec3(0.1 * t, 0.0, 5.0)).norm() <
                0.11); // a keyframe has no flow
    }
}

void LayeredPathTest::withoutHidingItStaysInTheCells()
{
    LayeredPathOptions visible;
    visible.hiddenPoints = 0;
    const auto path = shortestPath(behindAWall(30, 10, 18), visible, {});
    QVERIFY(path.ok());
    for (int cell : path->cells)
        QVERIFY(cell >= 0);
}

void LayeredPathTest::hidingIsNotForEver()
{
    LayeredPathOptions options;
    options.longestHidden = 5;
    const auto path = shortestPath(behindAWall(30, 10, 18), options, {});
    QVERIFY(path.ok());
    int longest = 0, run = 0;
    for (int cell : path->cells) {
        run = cell < 0 ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    QVERIFY(longest <= 5);
}

void LayeredPathTest::emptyLayersAreRefused()
{
    QVERIFY(!shortestPath({}, {}, {}).ok());
    Layers layers = randomLayers(1, 4, 3);
    layers[2].clear();
    QVERIFY(!shortestPath(layers, {}, {}).ok());
}

void LayeredPathTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    QVERIFY(shortestPath(randomLayers(1, 4, 3), {}, JobControl(&cancel, {})).error().isCancelled());
}

QTEST_APPLESS_MAIN(LayeredPathTest)
#include "layered_path_test.moc"
