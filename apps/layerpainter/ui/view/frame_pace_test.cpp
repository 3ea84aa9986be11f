#include "layerpainter/ui/view/frame_pace.h"

#include <QtTest>

using namespace ductus;

class FramePaceTest : public QObject
{
    Q_OBJECT
private slots:
    void staysSharpWhereFramesAreFast();
    void drawsSlowFramesCoarselyFromTheFirstOneOn();
    void getsCoarserButNeverFinerWithinAMovement();
    void takesARowOfEditsForAMovement();
};

void FramePaceTest::staysSharpWhereFramesAreFast()
{
    FramePace pace;
    pace.drawn(10);
    pace.move();
    QCOMPARE(pace.divisor(), 1);
    pace.drawn(12);
    QCOMPARE(pace.divisor(), 1);
}

void FramePaceTest::drawsSlowFramesCoarselyFromTheFirstOneOn()
{
    FramePace pace;
    pace.drawn(3 * FramePace::targetMilliseconds);
    pace.move();
    QCOMPARE(pace.divisor(), 2);
    pace.stop();
    QCOMPARE(pace.divisor(), 1);
    pace.drawn(1e6);
    pace.move();
    QCOMPARE(pace.divisor(), FramePace::coarsest);
}

void FramePaceTest::getsCoarserButNeverFinerWithinAMovement()
{
    FramePace pace;
    pace.drawn(3 * FramePace::targetMilliseconds);
    pace.move();
    pace.drawn(2 * FramePace::targetMilliseconds);
    QCOMPARE(pace.divisor(), 3);
    pace.drawn(1);
    pace.move();
    QCOMPARE(pace.divisor(), 3);
    pace.stop();
    pace.move(); // learnt
    QCOMPARE(pace.divisor(), 3);
}

void FramePaceTest::takesARowOfEditsForAMovement()
{
    FramePace pace;
    pace.edit(1000);
    QVERIFY(!pace.isMoving());
    pace.edit(1900);
    QVERIFY(!pace.isMoving());
    pace.edit(1950);
    QVERIFY(pace.isMoving());
}

QTEST_GUILESS_MAIN(FramePaceTest)
#include "frame_pace_test.moc"
