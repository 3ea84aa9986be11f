#include "support/tap_vid_metrics.h"

#include <QtTest>

using namespace ductus;

namespace {

std::vector<TapPoint> still(int frames)
{
    return std::vector<TapPoint>(std::size_t(frames), TapPoint{{100.0, 100.0}, true});
}

} // namespace

class TapVidMetricsTest : public QObject
{
    Q_OBJECT
private slots:
    void perfectTracksHaveFullMarks()
    {
        std::vector<TapPoint> truth = still(5);
        truth[3].isVisible = false;
        TapVidScore score;
        score.add(truth, truth, 0, TapQueries::Strided);
        QCOMPARE(score.averageJaccard(), 1.0);
        QCOMPARE(score.deltaAverage(), 1.0);
        QCOMPARE(score.occlusionAccuracy(), 1.0);
    }
    void distancesAreStrictlyLess()
    {
        const std::vector<TapPoint> truth = still(2);
        std::vector<TapPoint> said = truth;
        said[1].pixel.x() += 4.0;
        TapVidScore score;
        score.add(truth, said, 0, TapQueries::First);
        QCOMPARE(score.delta(2), 0.0);
        QCOMPARE(score.delta(3), 1.0);
        QCOMPARE(score.deltaAverage(), 0.4);
        // Wrong places said to be visible: at 1, 2, 4 a false positive beside the point that was not found.
        QCOMPARE(score.averageJaccard(), 0.4);
    }
    void falsePositivesAreCountedBesideTheVisible()
    {
        // Frames 1 to 4: found; missed (said hidden); said visible where it is hidden; rightly hidden.
        std::vector<TapPoint> truth = still(5), said = still(5);
        truth[3].isVisible = truth[4].isVisible = false;
        said[2].isVisible = said[4].isVisible = false;
        TapVidScore score;
        score.add(truth, said, 0, TapQueries::First);
        QCOMPARE(score.occlusionAccuracy(), 0.5);
        QCOMPARE(score.deltaAverage(), 1.0);         // whether it was said to be visible does not matter here
        QCOMPARE(score.averageJaccard(), 1.0 / 3.0); // 1 of 2 visible + 1 false
    }
    void firstLeavesOutWhatIsBefore()
    {
        const std::vector<TapPoint> truth = still(5);
        std::vector<TapPoint> said = truth;
        said[0].pixel.y() += 50.0;
        TapVidScore first, strided;
        first.add(truth, said, 2, TapQueries::First);
        strided.add(truth, said, 2, TapQueries::Strided);
        QCOMPARE(first.deltaAverage(), 1.0);
        QCOMPARE(strided.deltaAverage(), 0.75);
    }
    void nothingCountedIsNoDivisionByZero()
    {
        const TapVidScore score;
        QCOMPARE(score.averageJaccard(), 0.0);
        QCOMPARE(score.occlusionAccuracy(), 0.0);
    }
};

QTEST_APPLESS_MAIN(TapVidMetricsTest)
#include "tap_vid_metrics_test.moc"
