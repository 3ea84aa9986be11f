// What hands want, told from what they do.
#include "layerpainter/vr/hands/hand_commands.h"

#include <QtTest>

using namespace ductus;
using Kind = HandCommand::Kind;

namespace {

struct Hands
{
    HandsInput input;
    HandSituation situation;
    HandCommands commands;

    Hands()
    {
        for (HandInput &hand : input.hands)
            hand.isTracked = true;
        input.seconds = 0.011;
    }
    HandInput &painting() { return input.of(situation.painting); }
    HandInput &away() { return input.of(other(situation.painting)); }
    std::vector<HandCommand> frame() { return commands.read(input, situation); }
    std::vector<Kind> kinds()
    {
        std::vector<Kind> kinds;
        for (const HandCommand &command : frame())
            kinds.push_back(command.kind);
        return kinds;
    }
};

using Kinds = std::vector<Kind>;

} // namespace

class HandCommandsTest : public QObject
{
    Q_OBJECT
private slots:
    void pressureIsTheTriggers_data();
    void pressureIsTheTriggers();
    void aLostHandEndsTheStroke();
    void aStrokeGoesOnOverPanels();
    void panelsArePressedNotPaintedOn();
    void theOtherHandMayPaintFromNowOn();
    void sticksStepAndRepeat();
    void buttonsCountOnce();
    void gripsHoldAndCopy();
    void losingTheFocusEndsAll();
};

void HandCommandsTest::pressureIsTheTriggers_data()
{
    QTest::addColumn<bool>("left");
    QTest::newRow("right") << false;
    QTest::newRow("left") << true;
}

void HandCommandsTest::pressureIsTheTriggers()
{
    QFETCH(bool, left);
    Hands hands;
    hands.situation.painting = left ? Hand::Left : Hand::Right;
    hands.frame();
    hands.away().trigger = 1; // paints nothing
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().trigger = 0.06; // not yet
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().trigger = 0.3;
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::BeginStroke, 0.3}}));
    hands.painting().trigger = 0.06; // still: on and off are apart
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::ContinueStroke, 0.06}}));
    hands.painting().trigger = 0.02;
    QCOMPARE(hands.kinds(), Kinds{Kind::EndStroke});
    QCOMPARE(hands.kinds(), Kinds());
}

void HandCommandsTest::aLostHandEndsTheStroke()
{
    Hands hands;
    hands.painting().trigger = 1;
    QCOMPARE(hands.kinds(), Kinds{Kind::BeginStroke});
    hands.painting().isTracked = false;
    QCOMPARE(hands.kinds(), Kinds{Kind::EndStroke});
    hands.painting().isTracked = true; // and begins another by itself
    QCOMPARE(hands.kinds(), Kinds{Kind::BeginStroke});
}

void HandCommandsTest::aStrokeGoesOnOverPanels()
{
    Hands hands;
    hands.painting().trigger = 1;
    hands.frame();
    hands.situation.isOverPanel = true;
    QCOMPARE(hands.kinds(), Kinds{Kind::ContinueStroke});
}

void HandCommandsTest::panelsArePressedNotPaintedOn()
{
    Hands hands;
    hands.situation.isOverPanel = true;
    hands.painting().trigger = 0.3;
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().trigger = 0.6;
    QCOMPARE(hands.kinds(), Kinds{Kind::PressPanel});
    hands.situation.isOverPanel = false; // dragged off
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().trigger = 0.2;
    QCOMPARE(hands.kinds(), Kinds{Kind::ReleasePanel});
    QCOMPARE(hands.kinds(), Kinds()); // nor is anything painted until it was let go of
    hands.painting().trigger = 0;
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().trigger = 0.2;
    QCOMPARE(hands.kinds(), Kinds{Kind::BeginStroke});
}

void HandCommandsTest::theOtherHandMayPaintFromNowOn()
{
    Hands hands;
    hands.painting().trigger = 1;
    hands.away().trigger = 1;
    QCOMPARE(hands.kinds(), Kinds{Kind::BeginStroke});
    hands.situation.painting = Hand::Left;
    QCOMPARE(hands.kinds(), Kinds{Kind::EndStroke});
    QCOMPARE(hands.kinds(), Kinds()); // its trigger is down already
    hands.painting().trigger = 0;
    hands.frame();
    hands.painting().trigger = 1;
    QCOMPARE(hands.kinds(), Kinds{Kind::BeginStroke});
}

void HandCommandsTest::sticksStepAndRepeat()
{
    Hands hands;
    hands.painting().stick = {-0.9, 0.1};
    QCOMPARE(hands.kinds(), Kinds{Kind::Undo});
    int undone = 0;
    for (int i = 0; i < 90; ++i) // another second
        undone += int(hands.kinds().size());
    QVERIFY2(undone >= 2 && undone <= 4, qPrintable(QString::number(undone)));
    hands.painting().stick = {0.5, 0};          // not pushed anew
    QCOMPARE(hands.kinds(), Kinds{Kind::Redo}); // to the other side without rest
    hands.painting().stick = {0, 0};
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().stick = {0.5, 0};
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().stick = {0, 0};
    hands.away().stick = {1, 0};
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::TurnPanels, 1}}));
    for (int i = 0; i < 100; ++i)
        QCOMPARE(hands.kinds(), Kinds());
    hands.away().stick = {0, 0};
    hands.painting().stick = {0, 1};
    double factor = 1;
    for (int i = 0; i < 91; ++i)
        for (const HandCommand &command : hands.frame()) {
            QCOMPARE(command.kind, Kind::SizeBrush);
            factor *= command.value;
        }
    QVERIFY(std::abs(factor - 3) < 0.05); // in a second
}

void HandCommandsTest::buttonsCountOnce()
{
    Hands hands;
    hands.painting().primary = hands.painting().secondary = true;
    hands.away().primary = hands.away().secondary = true;
    QCOMPARE(hands.kinds().size(), std::size_t(4));
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().primary = false;
    hands.frame();
    hands.painting().primary = true;
    QCOMPARE(hands.kinds(), Kinds{Kind::Delete});
}

void HandCommandsTest::gripsHoldAndCopy()
{
    Hands hands;
    hands.painting().squeeze = 0.5;
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().squeeze = 0.7;
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::HoldRight, 1}}));
    hands.away().squeeze = 1;
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::HoldLeft, 1}}));
    hands.painting().squeeze = 0.3;
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::HoldRight, 0}}));
    hands.away().squeeze = 0;
    hands.frame();
    hands.situation.mode = HandMode::Select;
    hands.away().trigger = 1;
    hands.painting().squeeze = 1; // nothing is chosen: the canvas
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::HoldRight, 1}}));
    hands.painting().squeeze = 0;
    hands.frame();
    hands.situation.hasSelection = true;
    hands.painting().squeeze = 1;
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::HoldCopy, 1}}));
    hands.away().trigger = 0; // may be let go of
    QCOMPARE(hands.kinds(), Kinds());
    hands.painting().squeeze = 0;
    QCOMPARE(hands.frame(), std::vector<HandCommand>({{Kind::HoldCopy, 0}}));
}

void HandCommandsTest::losingTheFocusEndsAll()
{
    Hands hands;
    hands.painting().trigger = 1;
    hands.away().squeeze = 1;
    hands.frame();
    QCOMPARE(hands.commands.endAll(), std::vector<HandCommand>({{Kind::EndStroke}, {Kind::HoldLeft, 0}}));
    QCOMPARE(hands.commands.endAll(), std::vector<HandCommand>());
}

QTEST_APPLESS_MAIN(HandCommandsTest)
#include "hand_commands_test.moc"
