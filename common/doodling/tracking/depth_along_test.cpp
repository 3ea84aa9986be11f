#include "doodling/tracking/depth_along.h"

#include <QtTest>

using namespace ductus;

class DepthAlongTest : public QObject
{
    Q_OBJECT
private slots:
    void evenChangesStayAsTheyAre()
    {
        std::vector<MeasuredDepth> measured;
        for (int t = 0; t < 30; ++t)
            measured.push_back({5.0 * std::pow(1.02, t), 1.0});
        const std::vector<double> depths = smoothedDepths(measured);
        for (int t = 0; t < 30; ++t)
            QVERIFY(std::abs(depths[std::size_t(t)] / measured[std::size_t(t)].depth - 1.0) < 1e-9);
    }
    void jitterGoes()
    {
        std::vector<MeasuredDepth> measured;
        for (int t = 0; t < 40; ++t)
            measured.push_back({t % 2 ? 5.1 : 4.9, 1.0});
        const std::vector<double> depths = smoothedDepths(measured);
        for (std::size_t t = 3; t < 37; ++t)
            QVERIFY(std::abs(depths[t] - 5.0) < 0.02);
    }
    void whatPassesInFrontIsLeftOut()
    {
        std::vector<MeasuredDepth> measured(40, MeasuredDepth{8.0, 1.0});
        for (std::size_t t = 15; t < 20; ++t)
            measured[t] = {2.0, 1e-3};
        for (double depth : smoothedDepths(measured))
            QVERIFY(std::abs(depth - 8.0) < 0.05);
    }
    void shortClipsAreClipsToo()
    {
        QVERIFY(smoothedDepths({}).empty());
        QVERIFY(std::abs(smoothedDepths({{3.0, 1.0}}).at(0) - 3.0) < 1e-9);
        const std::vector<double> two = smoothedDepths({{3.0, 1.0}, {4.0, 1.0}});
        QVERIFY(std::abs(two[0] - 3.0) < 1e-9 && std::abs(two[1] - 4.0) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(DepthAlongTest)
#include "depth_along_test.moc"
