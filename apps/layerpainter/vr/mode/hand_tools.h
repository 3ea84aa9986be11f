// HandTools: what the hands want, done to the window's painting: strokes, choices, copies, undo. The same
// actions, brush, tools and selection as in the window.
#pragma once

#include "layerpainter/ui/window/painter_window.h"
#include "layerpainter/vr/hands/hand_commands.h"
#include "layerpainter/vr/hands/near_stroke.h"
#include "layerpainter/vr/hands/space_stroke.h"
#include "layerpainter/vr/hands/world_grab.h"

#include <functional>

namespace ductus {

class HandTools
{
public:
    explicit HandTools(PainterWindow &window);

    /// Felt in a hand: strength 0..1, seconds.
    void setTick(std::function<void(Hand, double, double)> tick) { mTick = std::move(tick); }

    /// Where the painting stands in the room.
    const Placement &roomFromScene() const { return mRoomFromScene; }
    void setRoomFromScene(const Placement &placement) { mRoomFromScene = placement; }

    Hand paintingHand() const { return mPaintingHand; }
    void setPaintingHand(Hand hand) { mPaintingHand = hand; }
    HandMode mode() const;
    bool isPainting() const { return mStroke.has_value(); }
    /// The brush's radius at full pressure, metres.
    double brushRadius() const { return mWindow.brush().halfWidth * mRoomFromScene.scale; }

    /// The layer whose row the ray is on, while it is: what is let go of there is dropped on it.
    void setDropLayer(std::optional<LayerId> layer) { mDropLayer = layer; }

    /// Those commands that are about the painting; panels are others' business.
    void perform(const std::vector<HandCommand> &commands, const HandsInput &input);

    /// The painting to show: with the stroke that is being painted.
    std::shared_ptr<const Painting> shown() const;

private:
    void beginStroke(const HandsInput &input, double pressure);
    void continueStroke(const HandsInput &input, double pressure);
    void endStroke();
    void choose(const HandsInput &input);
    void endChoice();
    void pickColour(const HandsInput &input);
    void moveHeld(const HandsInput &input);
    void holdCopy(bool held);
    std::optional<NearStroke> touched(const HandsInput &input, double reach) const;
    void tick(double strength, double seconds) const;

    PainterWindow &mWindow;
    std::function<void(Hand, double, double)> mTick;
    Placement mRoomFromScene;
    Hand mPaintingHand = Hand::Right;
    std::optional<SpaceStroke> mStroke;
    std::shared_ptr<const Painting> mBase, mPreview; // while a stroke is painted
    bool mIsChoosing = false;
    std::optional<ElementId> mChosenAgain; // was chosen already when the trigger was pulled
    std::optional<LayerId> mDropLayer;
    bool mHolds[2] = {false, false};
    WorldGrab mWorld;
    struct Copy
    {
        std::vector<ElementId> originals;
        Placement start; // of the scene in the room, as a thing the hand holds
        Placement present;
        WorldGrab grab;
        quint64 drag = 0;
    };
    std::optional<Copy> mCopy;
    quint64 mDrags = 0;
};

} // namespace ductus
