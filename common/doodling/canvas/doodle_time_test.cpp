#include "doodling/canvas/doodle_time.h"

#include <QtTest>

using namespace ductus;

namespace {

Doodle doodleOf(std::vector<int> holds, DoodleRepeat repeat, int offset = 0)
{
    Doodle doodle;
    doodle.frames.clear();
    for (int hold : holds)
        doodle.frames.push_back({{}, hold});
    doodle.repeat = repeat;
    doodle.offset = offset;
    return doodle;
}

// One digit a video frame from \a first on, '.' for nothing.
QString shown(const Doodle &doodle, int first, int count)
{
    QString text;
    for (int t = first; t < first + count; ++t) {
        const std::optional<int> index = doodleFrameAt(doodle, t);
        text += index ? QString::number(*index) : QString(".");
    }
    return text;
}

} // namespace

class DoodleTimeTest : public QObject
{
    Q_OBJECT
private slots:
    void repeats()
    {
        QCOMPARE(shown(doodleOf({2, 1, 3}, DoodleRepeat::Loop), 0, 14), "00122200122200");
        QCOMPARE(shown(doodleOf({2, 1, 3}, DoodleRepeat::PingPong), 0, 14), "00122210012221");
        QCOMPARE(shown(doodleOf({2, 1, 3}, DoodleRepeat::Once), -2, 10), "..001222..");
        QCOMPARE(shown(doodleOf({2, 1, 3}, DoodleRepeat::HoldLast), -2, 10), "..00122222");
        QCOMPARE(shown(doodleOf({5}, DoodleRepeat::PingPong), 0, 7), "0000000");
        QCOMPARE(shown(doodleOf({1, 1}, DoodleRepeat::PingPong), 0, 6), "010101");
    }
    void offsetsGoBothWays()
    {
        QCOMPARE(shown(doodleOf({1, 2}, DoodleRepeat::Loop, 4), 0, 8), "10110110");
        QCOMPARE(shown(doodleOf({1, 2}, DoodleRepeat::Loop, -1), 0, 5), "11011");
        QCOMPARE(shown(doodleOf({1, 2}, DoodleRepeat::Once, 4), 0, 8), "....011.");
    }
    void findsTheNextShowing()
    {
        const Doodle doodle = doodleOf({2, 1, 3}, DoodleRepeat::Loop);
        QCOMPARE(nextShowing(doodle, 1, 0).value(), 2);
        QCOMPARE(nextShowing(doodle, 1, 3).value(), 8);
        QCOMPARE(nextShowing(doodleOf({2, 1}, DoodleRepeat::Once, 20), 1, 3).value(), 22);
        QVERIFY(!nextShowing(doodleOf({2, 1}, DoodleRepeat::Once), 0, 3));
        QVERIFY(!nextShowing(doodle, 3, 0));
    }
    void onionSkinGoesRoundInLoopsOnly()
    {
        const auto indices = [](const std::vector<OnionLayer> &layers) {
            QString text;
            for (const OnionLayer &layer : layers)
                text += QString("%1(%2) ").arg(layer.index).arg(layer.steps);
            return text.trimmed();
        };
        const Doodle loop = doodleOf({1, 1, 1, 1, 1, 1}, DoodleRepeat::Loop);
        QCOMPARE(indices(onionSkin(loop, 0, 2, 1)), "4(-2) 5(-1) 1(1)");
        QCOMPARE(indices(onionSkin(loop, 3, 1, 1)), "2(-1) 4(1)");
        const Doodle once = doodleOf({1, 1, 1}, DoodleRepeat::Once);
        QCOMPARE(indices(onionSkin(once, 0, 2, 1)), "1(1)");
        // Both ways round a loop of three meet the same two frames.
        QCOMPARE(indices(onionSkin(doodleOf({1, 1, 1}, DoodleRepeat::Loop), 0, 2, 2)), "2(-1) 1(1)");
        QVERIFY(onionSkin(doodleOf({1}, DoodleRepeat::Loop), 0, 3, 3).empty());
        QVERIFY(onionSkin(loop, 2, 1, 1)[0].opacity > 0.0);
    }
};

QTEST_APPLESS_MAIN(DoodleTimeTest)
#include "doodle_time_test.moc"
