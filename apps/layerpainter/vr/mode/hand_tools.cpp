#include "layerpainter/vr/mode/hand_tools.h"

#include "painting/blend/blend.h"

#include <algorithm>
#include <atomic>

namespace ductus {

namespace {

using Kind = HandCommand::Kind;

constexpr double chooseReach = 0.025, colourReach = 0.05; // metres from a stroke's skin

// Numbers of drags are told apart by the document from those of the window's sliders, which count from 1.
constexpr quint64 firstDrag = quint64(1) << 40;

} // namespace

HandTools::HandTools(PainterWindow &window) : mWindow(window), mDrags(firstDrag) {}

HandMode HandTools::mode() const
{
    const PainterTool tool = mWindow.tool();
    return tool == PainterTool::Select || tool == PainterTool::Move ? HandMode::Select : HandMode::Paint;
}

void HandTools::tick(double strength, double seconds) const
{
    if (mTick)
        mTick(mPaintingHand, strength, seconds);
}

std::shared_ptr<const Painting> HandTools::shown() const
{
    return mPreview ? mPreview : mWindow.painting().sharedPainting();
}

void HandTools::perform(const std::vector<HandCommand> &commands, const HandsInput &input)
{
    for (const HandCommand &command : commands) {
        switch (command.kind) {
        case Kind::BeginStroke:
            beginStroke(input, command.value);
            break;
        case Kind::ContinueStroke:
            continueStroke(input, command.value);
            break;
        case Kind::EndStroke:
            endStroke();
            break;
        case Kind::Choose:
            choose(input);
            break;
        case Kind::EndChoice:
            endChoice();
            break;
        case Kind::HoldLeft:
        case Kind::HoldRight:
            mHolds[command.kind == Kind::HoldLeft ? 0 : 1] = command.value > 0;
            break;
        case Kind::HoldCopy:
            holdCopy(command.value > 0);
            break;
        case Kind::Undo:
            mWindow.painting().undoStack()->undo();
            break;
        case Kind::Redo:
            mWindow.painting().undoStack()->redo();
            break;
        case Kind::SizeBrush:
            mWindow.brush().halfWidth *= command.value;
            mWindow.brushPanel().step(0); // takes the number over, within its bounds
            break;
        case Kind::Delete:
            if (!mWindow.view().selection().empty()) {
                (void)mWindow.painting().perform(act::Erase{mWindow.view().selection()});
                tick(0.6, 0.03);
            }
            break;
        case Kind::PickColour:
            pickColour(input);
            break;
        case Kind::ChangeMode:
            mWindow.setTool(mode() == HandMode::Paint ? PainterTool::Select : PainterTool::Paint);
            tick(0.3, 0.02);
            break;
        case Kind::PressPanel:
        case Kind::ReleasePanel:
        case Kind::TurnPanels:
        case Kind::ShowPanels:
            break;
        }
    }
    moveHeld(input);
}

void HandTools::beginStroke(const HandsInput &input, double pressure)
{
    const BrushState &brush = mWindow.brush();
    mBase = mWindow.painting().sharedPainting();
    mStroke.emplace(SpaceStroke::Brush{brush.halfWidth, brush.colour, brush.section});
    continueStroke(input, pressure);
}

void HandTools::continueStroke(const HandsInput &input, double pressure)
{
    if (!mStroke || !mStroke->add(input.of(mPaintingHand).aim, pressure, mRoomFromScene))
        return;
    const act::Draw action =
        drawAction(*mBase, mWindow.brush().layer, mWindow.view().seconds(), mStroke->shape());
    // What is refused is told when the stroke is done.
    if (Result<PerformedAction> result = performed(*mBase, action); result)
        mPreview = std::make_shared<const Painting>(std::move(result->painting));
}

void HandTools::endStroke()
{
    if (!mStroke)
        return;
    const StrokeShape shape = mStroke->shape();
    mStroke.reset();
    mBase = mPreview = nullptr;
    PaintingDocument &document = mWindow.painting();
    if (!shape.points.empty())
        (void)document.perform(
            drawAction(document.painting(), mWindow.brush().layer, mWindow.view().seconds(), shape));
}

std::optional<NearStroke> HandTools::touched(const HandsInput &input, double reach) const
{
    const HandInput &hand = input.of(mPaintingHand);
    if (!hand.isTracked)
        return std::nullopt;
    return nearStroke(mWindow.painting().painting(), mWindow.view().seconds(),
                      mRoomFromScene.matrix().inverse() * hand.aim.position, reach / mRoomFromScene.scale,
                      mWindow.brush().layer);
}

// Chooses a stroke more; one that is chosen already is carried, or let go of if it is not.
void HandTools::choose(const HandsInput &input)
{
    mIsChoosing = true;
    mChosenAgain.reset();
    const auto found = touched(input, chooseReach);
    if (!found)
        return;
    std::vector<ElementId> chosen = mWindow.view().selection();
    if (std::ranges::find(chosen, found->element) != chosen.end()) {
        mChosenAgain = found->element;
    } else {
        chosen.push_back(found->element);
        mWindow.view().setSelection(std::move(chosen));
    }
    tick(0.5, 0.02);
}

void HandTools::endChoice()
{
    if (!std::exchange(mIsChoosing, false))
        return;
    std::vector<ElementId> chosen = mWindow.view().selection();
    if (mDropLayer && !chosen.empty()) {
        if (mWindow.painting().perform(act::MoveElements{chosen, *mDropLayer, 0}))
            tick(0.8, 0.04);
    } else if (mChosenAgain) {
        std::erase(chosen, *mChosenAgain);
        mWindow.view().setSelection(std::move(chosen));
    }
}

void HandTools::pickColour(const HandsInput &input)
{
    const auto found = touched(input, colourReach);
    if (!found)
        return;
    const Eigen::Vector3d encoded = encodedFromLinear(found->colour.cast<double>());
    mWindow.colourPanel().setColour(
        QColor::fromRgbF(float(encoded.x()), float(encoded.y()), float(encoded.z())));
    tick(0.5, 0.02);
}

void HandTools::holdCopy(bool held)
{
    if (!held) {
        mCopy.reset();
        return;
    }
    mCopy = Copy{mWindow.view().selection(), mRoomFromScene, mRoomFromScene, {}, ++mDrags};
}

void HandTools::moveHeld(const HandsInput &input)
{
    const auto poseOf = [&](Hand hand, bool isHeld) {
        const HandInput &is = input.of(hand);
        return isHeld && is.isTracked ? std::optional(is.grip) : std::nullopt;
    };
    const double before = mRoomFromScene.scale;
    mRoomFromScene =
        mWorld.move(poseOf(Hand::Left, mHolds[0]), poseOf(Hand::Right, mHolds[1]), mRoomFromScene);
    if (mRoomFromScene.scale != before) { // the brush stays as large as it is in the hand
        mWindow.brush().halfWidth *= before / mRoomFromScene.scale;
        mWindow.brushPanel().step(0);
    }
    if (!mCopy)
        return;
    const bool isLeft = mPaintingHand == Hand::Left;
    mCopy->present =
        mCopy->grab.move(poseOf(Hand::Left, isLeft), poseOf(Hand::Right, !isLeft), mCopy->present);
    // Each time the whole way from where the originals are: one step of the history.
    act::Duplicate copy{mCopy->originals, mWindow.brush().layer, 0, {}};
    copy.change = inverseOf(mCopy->start) * mCopy->present;
    if (const auto made = mWindow.painting().perform(copy, mCopy->drag)) {
        std::vector<ElementId> copies;
        for (const std::int32_t id : *made)
            copies.push_back(ElementId{id});
        mWindow.view().setSelection(std::move(copies));
    } else {
        mCopy.reset(); // told once
    }
}

} // namespace ductus
