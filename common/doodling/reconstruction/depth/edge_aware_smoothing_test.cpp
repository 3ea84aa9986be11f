#include "doodling/reconstruction/depth/edge_aware_smoothing.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int width = 32, height = 16;

// Dark to the left, bright to the right.
Image twoHalves()
{
    Image image(width, height, {20, 20, 20, 255});
    for (int y = 0; y < height; ++y)
        for (int x = width / 2; x < width; ++x)
            image.set(x, y, {230, 230, 230, 255});
    return image;
}

} // namespace

class EdgeAwareSmoothingTest : public QObject
{
    Q_OBJECT
private slots:
    void whatIsKnownSpreadsUpToEdges()
    {
        const EdgeWeights edges = edgeWeights(twoHalves(), 1, 10.0);
        std::vector<float> values(width * height, 0.0f), weights(width * height, 0.0f);
        values[3 * width + 2] = 1.0f;
        weights[3 * width + 2] = 1.0f;
        values[12 * width + 29] = 5.0f;
        weights[12 * width + 29] = 1.0f;
        const std::vector<float> all = smoothed(edges, values, weights);
        QVERIFY(std::abs(all[10 * width + 14] - 1.0f) < 0.1f);
        QVERIFY(std::abs(all[2 * width + 17] - 5.0f) < 0.3f);
    }
    void whatIsSureStays()
    {
        const EdgeWeights edges = edgeWeights(Image(width, height, {90, 90, 90, 255}), 1, 10.0);
        std::vector<float> values(width * height), weights(width * height, 1e6f);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = float(i % 7);
        const std::vector<float> weak = smoothed(edges, values, weights, {1e-3, 2});
        for (std::size_t i = 0; i < values.size(); ++i)
            QVERIFY(std::abs(weak[i] - values[i]) < 0.05f);
        const std::vector<float> strong = smoothed(edges, values, weights, {1000.0, 3});
        const auto [least, most] = std::minmax_element(strong.begin(), strong.end());
        QVERIFY(*most - *least < 0.5f);
    }
    void nothingKnownIsZero()
    {
        const EdgeWeights edges = edgeWeights(twoHalves(), 4, 10.0);
        QCOMPARE(edges.width, width / 4);
        const std::vector<float> none(std::size_t(edges.width * edges.height), 0.0f);
        for (float value : smoothed(edges, none, none))
            QCOMPARE(value, 0.0f);
    }
};

QTEST_APPLESS_MAIN(EdgeAwareSmoothingTest)
#include "edge_aware_smoothing_test.moc"
