#include "doodling/reconstruction/depth_map.h"

#include <QtTest>
#include <limits>

using namespace ductus;

class DepthMapTest : public QObject
{
    Q_OBJECT
private slots:
    void keepsDepthsToParts()
    {
        const std::vector<float> disparities = {0.5f, 0.25f, 0.1f, 0.02f};
        const DepthMap map = depthMapOf(2, 2, 4.0, disparities);
        QVERIFY(std::abs(map.depthAt({2.0, 2.0}) - 2.0) < 1e-3);
        QVERIFY(std::abs(map.depthAt({6.0, 2.0}) - 4.0) < 1e-3);
        QVERIFY(std::abs(map.depthAt({6.0, 6.0}) - 50.0) < 0.1);
        QCOMPARE(map.objectAt({1.0, 1.0}), 0);
    }
    void slopesAreMixedSilhouettesAreNot()
    {
        const DepthMap slope = depthMapOf(2, 1, 4.0, std::vector<float>{0.50f, 0.52f});
        QVERIFY(std::abs(1.0 / slope.depthAt({4.0, 2.0}) - 0.51) < 1e-4);
        const DepthMap edge = depthMapOf(2, 1, 4.0, std::vector<float>{0.5f, 0.1f});
        QVERIFY(std::abs(edge.depthAt({3.9, 2.0}) - 2.0) < 1e-3);
        QVERIFY(std::abs(edge.depthAt({4.1, 2.0}) - 10.0) < 1e-2);
    }
    void placesOutsideCountAsTheBorder()
    {
        const DepthMap map = depthMapOf(2, 1, 4.0, std::vector<float>{0.5f, 0.1f});
        QVERIFY(std::abs(map.depthAt({-50.0, 900.0}) - 2.0) < 1e-3);
        QVERIFY(std::abs(map.depthAt({1e9, -3.0}) - 10.0) < 1e-2);
    }
    void whatIsNoDepthBecomesFar()
    {
        const std::vector<float> disparities = {std::numeric_limits<float>::quiet_NaN(), -1.0f, 0.0f, 1.0f};
        const DepthMap map = depthMapOf(2, 2, 1.0, disparities);
        for (const Eigen::Vector2d &pixel : {Eigen::Vector2d(0.5, 0.5), {1.5, 0.5}, {0.5, 1.5}}) {
            QVERIFY(std::isfinite(map.depthAt(pixel)));
            QVERIFY(map.depthAt(pixel) > 1000.0);
        }
        const DepthMap none = depthMapOf(1, 1, 1.0, std::vector<float>{0.0f});
        QVERIFY(std::isfinite(none.depthAt({0.0, 0.0})));
    }
    void saysWhatMoves()
    {
        DepthMap map = depthMapOf(2, 1, 4.0, std::vector<float>{0.5f, 0.1f});
        map.objects = std::vector<std::uint8_t>{0, 3};
        QCOMPARE(map.objectAt({3.0, 1.0}), 0);
        QCOMPARE(map.objectAt({5.0, 1.0}), 3);
    }
};

QTEST_APPLESS_MAIN(DepthMapTest)
#include "depth_map_test.moc"
