#include "doodling/reconstruction/long_flow.h"

#include <QtTest>

using namespace ductus;

class LongFlowTest : public QObject
{
    Q_OBJECT
private slots:
    void compactFlowSaysTheSame()
    {
        FlowField field{3, 2, 4.0, {}, {}};
        for (int i = 0; i < 6; ++i) {
            field.motions.emplace_back(7.3f * float(i) - 12.1f, -3.7f * float(i));
            field.confidences.push_back(0.15f * float(i));
        }
        const CompactFlow compact = compacted(field);
        const FlowField back = expanded(compact);
        for (double y = -3.0; y < 12.0; y += 1.7)
            for (double x = -3.0; x < 16.0; x += 1.3) {
                const MotionAt exact = field.at({x, y}), near = compact.at({x, y});
                QVERIFY((exact.motion - near.motion).norm() < 0.03);
                QVERIFY(std::abs(exact.confidence - near.confidence) < 0.003);
                QCOMPARE(back.at({x, y}).motion, near.motion);
                QCOMPARE(exact.motion, field.motionAt({x, y}));
                QCOMPARE(exact.confidence, field.confidenceAt({x, y}));
            }
    }
    void missesComeBackFromConfidences()
    {
        // A step of 10 pixels that comes home 1.2 pixels off: half trust is at 0.7 + 0.05 * 10.
        QVERIFY(std::abs(missOf({{10.0, 0.0}, 0.5}) - 1.2) < 1e-9);
        QCOMPARE(missOf({{10.0, 0.0}, 1.0}), 0.0);
        QVERIFY(missOf({{0.0, 0.0}, 0.0}) > 20.0);
    }
    void shortClipsHaveAllGapsLongOnesFewer()
    {
        QCOMPARE(longGapsTo(1, 90), std::vector<int>{});
        QCOMPARE(longGapsTo(5, 90), (std::vector<int>{2, 4}));
        QCOMPARE(longGapsTo(33, 90), (std::vector<int>{2, 4, 8, 16}));
        int flows = 0;
        for (int t = 0; t < 1800; ++t)
            flows += int(longGapsTo(t, 1800).size());
        QVERIFY2(flows < 2 * 1800, qPrintable(QString::number(flows)));
    }
};

QTEST_APPLESS_MAIN(LongFlowTest)
#include "long_flow_test.moc"
