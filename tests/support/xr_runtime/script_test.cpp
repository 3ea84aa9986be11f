// The script of the simulated headset.
#include "support/xr_runtime/script.h"

#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

using namespace ductus::xr;

class ScriptTest : public QObject
{
    Q_OBJECT
private slots:
    void linesHoldFromTheirFrameOn();
    void rampsGoEvenlyFromWhereTheyBegin();
    void whatIsWrittenLaterIsReadLater();
    void ordersComeOnce();
    void nonsenseIsToldAndChangesNothing();
};

void ScriptTest::linesHoldFromTheirFrameOn()
{
    Script script;
    script.add("head 1 2 3 0 0.7071068 0 0.7071068");
    script.add("4 tracked left 0");
    script.add("4 input right/input/trigger/value 0.75   # a comment");
    script.advance(3);
    QCOMPARE(script.scene().head.position, Eigen::Vector3d(1, 2, 3));
    QVERIFY(std::abs(script.scene().head.orientation.y() - std::sqrt(0.5)) < 1e-6);
    QVERIFY(script.scene().tracked[0]);
    script.advance(4);
    QVERIFY(!script.scene().tracked[0]);
    QVERIFY(script.scene().tracked[1]);
    QCOMPARE(script.scene().inputs.at("/user/hand/right/input/trigger/value"), 0.75);
}

void ScriptTest::rampsGoEvenlyFromWhereTheyBegin()
{
    Script script;
    script.add("right 0 1 0");
    script.advance(0);
    script.add("10-20 right 1 1 -2");
    script.advance(9);
    QCOMPARE(script.scene().hands[1].position, Eigen::Vector3d(0, 1, 0));
    for (int frame = 10; frame <= 15; ++frame)
        script.advance(frame);
    QCOMPARE(script.scene().hands[1].position, Eigen::Vector3d(0.5, 1, -1));
    for (int frame = 16; frame <= 25; ++frame)
        script.advance(frame);
    QCOMPARE(script.scene().hands[1].position, Eigen::Vector3d(1, 1, -2));
    script.add("+4 input left/input/squeeze/value 1");
    script.advance(27);
    QCOMPARE(script.scene().inputs.at("/user/hand/left/input/squeeze/value"), 0.5);
}

void ScriptTest::whatIsWrittenLaterIsReadLater()
{
    QTemporaryDir folder;
    const std::string path = folder.filePath("script").toStdString();
    std::ofstream stream(path);
    stream << "size 64 32\nstage 0\nhead 0 1" << std::flush; // the last line is not finished
    Script script(path);
    QCOMPARE(script.scene().width, 64);
    QCOMPARE(script.scene().height, 32);
    QVERIFY(!script.scene().hasStage);
    QVERIFY(script.mistakes().empty());
    stream << ".7 0.2\n" << std::flush;
    script.advance(1);
    QCOMPARE(script.scene().head.position, Eigen::Vector3d(0, 1.7, 0.2));
}

void ScriptTest::ordersComeOnce()
{
    Script script;
    script.add("2 state visible");
    script.add("2 fail xrWaitFrame -12 3");
    script.add("3 lose session");
    script.advance(1);
    QVERIFY(script.takeOrders().empty());
    script.advance(2);
    const std::vector<Order> orders = script.takeOrders();
    QCOMPARE(orders.size(), std::size_t(2));
    QCOMPARE(orders[0].word, std::string("visible"));
    QCOMPARE(orders[1].code, -12);
    QCOMPARE(orders[1].times, 3);
    QVERIFY(script.takeOrders().empty());
    script.advance(3);
    QCOMPARE(script.takeOrders().size(), std::size_t(1));
}

void ScriptTest::nonsenseIsToldAndChangesNothing()
{
    Script script;
    for (const char *line : {"head 1 2", "head one two three", "input right/input/a/click", "lose marbles",
                             "9-3 headset 0", "dance"})
        script.add(line);
    script.advance(20);
    QCOMPARE(script.mistakes().size(), std::size_t(6));
    QCOMPARE(script.scene().head.position, Eigen::Vector3d(0, 1.6, 0));
    QVERIFY(script.scene().hasHeadset);
}

QTEST_APPLESS_MAIN(ScriptTest)
#include "script_test.moc"
