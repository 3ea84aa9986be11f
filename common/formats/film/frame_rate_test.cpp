#include "formats/film/frame_rate.h"

#include <QtTest>
#include <cmath>
#include <vector>

using namespace ductus;

class FrameRateTest : public QObject
{
    Q_OBJECT
private slots:
    void knownRatesAreFound()
    {
        QCOMPARE(frameRateNear(25.0), (FrameRate{25, 1}));
        QCOMPARE(frameRateNear(29.97), (FrameRate{30000, 1001}));
        QCOMPARE(frameRateNear(23.976), (FrameRate{24000, 1001}));
        QCOMPARE(frameRateNear(59.9401), (FrameRate{60000, 1001}));
        QCOMPARE(frameRateNear(30.0), (FrameRate{30, 1}));
        QCOMPARE(frameRateNear(12.5), (FrameRate{25, 2}));
        QVERIFY(std::abs(frameRateNear(17.2371).perSecond() - 17.2371) < 1e-5);
        QVERIFY(frameRateNear(0.0004).perSecond() > 0.0);
    }
    void evenStepsAreTold()
    {
        std::vector<double> times;
        for (int i = 0; i < 90; ++i)
            times.push_back(std::round(1000.0 * i * 1001 / 30000) / 1000); // as Matroska rounds them
        const std::optional<FrameRate> rate = evenFrameRate(times);
        QVERIFY(rate.has_value());
        QCOMPARE(*rate, (FrameRate{30000, 1001}));
        times[40] += 0.008;
        QVERIFY(!evenFrameRate(times));
        QVERIFY(!evenFrameRate(std::vector<double>{0.0}));
        QVERIFY(!evenFrameRate(std::vector<double>{}));
    }
};

QTEST_APPLESS_MAIN(FrameRateTest)
#include "frame_rate_test.moc"
