#include "layerpainter/vr/hands/hand_commands.h"

#include <cmath>

namespace ductus {

namespace {

using Kind = HandCommand::Kind;

// On and off are apart, so that a trembling finger does not stutter.
constexpr double strokeOn = 0.10, strokeOff = 0.05;
constexpr double pressOn = 0.50, pressOff = 0.30;
constexpr double gripOn = 0.60, gripOff = 0.40;
constexpr double stickOn = 0.70, stickOff = 0.40;
constexpr double firstRepeat = 0.5, nextRepeat = 0.2; // seconds
constexpr double sizePerSecond = 3;                   // factor of a stick pushed all the way

int place(Hand hand)
{
    return hand == Hand::Left ? 0 : 1;
}

} // namespace

std::vector<HandCommand> HandCommands::read(const HandsInput &input, const HandSituation &situation)
{
    std::vector<HandCommand> out;
    if (situation.painting != mPainting) {
        out = endAll();
        mPainting = situation.painting;
        mTrigger = Trigger::Waiting;
    }
    readTrigger(input.of(mPainting), situation, out);
    readGrips(input, situation, out);
    readSticks(input, situation, out);
    readButtons(input, situation, out);
    return out;
}

void HandCommands::endTrigger(std::vector<HandCommand> &out)
{
    if (mTrigger == Trigger::Stroke)
        out.push_back({Kind::EndStroke});
    else if (mTrigger == Trigger::Choice)
        out.push_back({Kind::EndChoice});
    else if (mTrigger == Trigger::Panel)
        out.push_back({Kind::ReleasePanel});
}

std::vector<HandCommand> HandCommands::endAll()
{
    std::vector<HandCommand> out;
    endTrigger(out);
    mTrigger = Trigger::Waiting;
    if (mHoldsCopy)
        out.push_back({Kind::HoldCopy, 0});
    for (const int hand : {0, 1})
        if (mHolds[hand])
            out.push_back({hand == 0 ? Kind::HoldLeft : Kind::HoldRight, 0});
    mHoldsCopy = mHolds[0] = mHolds[1] = false;
    return out;
}

void HandCommands::readTrigger(const HandInput &hand, const HandSituation &situation,
                               std::vector<HandCommand> &out)
{
    const double value = hand.isTracked ? hand.trigger : 0;
    switch (mTrigger) {
    case Trigger::Waiting: // a hand that is not there has let go of nothing
        if (hand.isTracked && value < strokeOff)
            mTrigger = Trigger::Free;
        return;
    case Trigger::Free:
        if (situation.isOverPanel) {
            if (value >= pressOn) {
                mTrigger = Trigger::Panel;
                out.push_back({Kind::PressPanel});
            }
        } else if (situation.mode == HandMode::Paint && value >= strokeOn) {
            mTrigger = Trigger::Stroke;
            out.push_back({Kind::BeginStroke, value});
        } else if (situation.mode == HandMode::Select && value >= pressOn) {
            mTrigger = Trigger::Choice;
            out.push_back({Kind::Choose});
        }
        return;
    case Trigger::Stroke:
        if (value >= strokeOff) {
            out.push_back({Kind::ContinueStroke, value});
            return;
        }
        break;
    case Trigger::Choice:
    case Trigger::Panel:
        if (value >= pressOff)
            return;
        break;
    }
    endTrigger(out);
    mTrigger = value < strokeOff ? Trigger::Free : Trigger::Waiting;
}

void HandCommands::readGrips(const HandsInput &input, const HandSituation &situation,
                             std::vector<HandCommand> &out)
{
    for (const Hand hand : {Hand::Left, Hand::Right}) {
        const HandInput &is = input.of(hand);
        const double value = is.isTracked ? is.squeeze : 0;
        bool &holds = mHolds[place(hand)];
        const bool isPainting = hand == mPainting;
        if (isPainting && mHoldsCopy) {
            if (value < gripOff) {
                mHoldsCopy = false;
                out.push_back({Kind::HoldCopy, 0});
            }
            continue;
        }
        const bool now = holds ? value >= gripOff : value >= gripOn;
        if (now == holds)
            continue;
        const HandInput &away = input.of(other(hand));
        if (now && isPainting && situation.hasSelection && away.isTracked && away.trigger >= pressOn) {
            mHoldsCopy = true;
            out.push_back({Kind::HoldCopy, 1});
            continue;
        }
        holds = now;
        out.push_back({hand == Hand::Left ? Kind::HoldLeft : Kind::HoldRight, now ? 1.0 : 0.0});
    }
}

void HandCommands::readSticks(const HandsInput &input, const HandSituation &situation,
                              std::vector<HandCommand> &out)
{
    for (const Hand hand : {Hand::Left, Hand::Right}) {
        const HandInput &is = input.of(hand);
        const Eigen::Vector2d stick = is.isTracked ? is.stick : Eigen::Vector2d::Zero();
        int &step = mStep[place(hand)];
        double &heldFor = mHeldFor[place(hand)];
        const bool isSideways = std::abs(stick.x()) >= std::abs(stick.y());
        const bool isPushed = isSideways && std::abs(stick.x()) >= (step != 0 ? stickOff : stickOn);
        const int direction = isPushed ? (stick.x() > 0 ? 1 : -1) : 0;
        bool isDue = direction != 0 && direction != step;
        if (direction != 0 && direction == step) {
            heldFor += input.seconds;
            if (heldFor >= firstRepeat) {
                heldFor -= nextRepeat;
                isDue = hand == mPainting; // undoing goes on; panels turn once a push
            }
        } else {
            heldFor = 0;
        }
        step = direction;
        if (isDue && hand == mPainting && mTrigger != Trigger::Stroke)
            out.push_back({direction < 0 ? Kind::Undo : Kind::Redo});
        else if (isDue && hand != mPainting)
            out.push_back({Kind::TurnPanels, double(direction)});
        if (hand == mPainting && !isSideways && std::abs(stick.y()) > stickOff)
            out.push_back({Kind::SizeBrush, std::pow(sizePerSecond, stick.y() * input.seconds)});
    }
}

void HandCommands::readButtons(const HandsInput &input, const HandSituation &situation,
                               std::vector<HandCommand> &out)
{
    for (const Hand hand : {Hand::Left, Hand::Right}) {
        const HandInput &is = input.of(hand);
        const bool now[2] = {is.isTracked && is.primary, is.isTracked && is.secondary};
        const Kind painting[2] = {Kind::Delete, Kind::PickColour},
                   away[2] = {Kind::ChangeMode, Kind::ShowPanels};
        for (const int button : {0, 1}) {
            bool &was = mButtons[place(hand)][button];
            const bool isPressed = now[button] && !was;
            was = now[button];
            if (!isPressed)
                continue;
            // A stroke is not torn by a button that is hit by accident.
            if (mTrigger == Trigger::Stroke)
                continue;
            out.push_back({hand == mPainting ? painting[button] : away[button]});
        }
    }
}

} // namespace ductus
