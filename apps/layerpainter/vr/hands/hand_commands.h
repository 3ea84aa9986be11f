// HandCommands: what the hands want, out of what they do; nothing of OpenXR, nothing of the painting.
//
//     the painting hand   trigger paints, chooses, presses what the ray points at; grip holds the canvas, or
//                         with the other trigger a copy of what is chosen; stick left and right undoes and
//                         redoes, up and down sizes; A deletes, B picks the colour
//     the other hand      grip holds the canvas; stick turns the panels; X paints or selects, Y shows panels
#pragma once

#include "layerpainter/vr/hands/hand_input.h"

#include <vector>

namespace ductus {

enum class HandMode { Paint, Select };

struct HandCommand
{
    enum class Kind {
        BeginStroke, // value: pressure, as of the next two
        ContinueStroke,
        EndStroke,
        Choose,    // what is at the tip
        EndChoice, // the trigger is let go of; over a panel: dropped there
        PressPanel,
        ReleasePanel,
        HoldLeft, // value: 1 held, 0 let go
        HoldRight,
        HoldCopy, // a copy of what is chosen, by the painting hand; value as above
        Undo,
        Redo,
        SizeBrush,  // value: factor
        TurnPanels, // value: 1 to the right, -1 to the left
        ShowPanels, // or hide
        Delete,
        PickColour,
        ChangeMode,
    };
    Kind kind;
    double value = 0;
    bool operator==(const HandCommand &other) const = default;
};

/// What the hands are at.
struct HandSituation
{
    HandMode mode = HandMode::Paint;
    Hand painting = Hand::Right;
    bool isOverPanel = false; // the painting hand's ray or tip
    bool hasSelection = false;
};

class HandCommands
{
public:
    /// What is begun is ended before anything else, also when a hand is lost or the painting hand changes.
    std::vector<HandCommand> read(const HandsInput &input, const HandSituation &situation);

    /// Ends what is under way: the focus is lost, VR ends.
    std::vector<HandCommand> endAll();

private:
    enum class Trigger { Free, Waiting, Stroke, Choice, Panel }; // Waiting: to be let go of

    void readTrigger(const HandInput &hand, const HandSituation &situation, std::vector<HandCommand> &out);
    void readGrips(const HandsInput &input, const HandSituation &situation, std::vector<HandCommand> &out);
    void readSticks(const HandsInput &input, const HandSituation &situation, std::vector<HandCommand> &out);
    void readButtons(const HandsInput &input, const HandSituation &situation, std::vector<HandCommand> &out);
    void endTrigger(std::vector<HandCommand> &out);

    Hand mPainting = Hand::Right;
    Trigger mTrigger = Trigger::Free;
    bool mHolds[2] = {false, false};
    bool mHoldsCopy = false;
    int mStep[2] = {0, 0};       // direction a stick is pushed in
    double mHeldFor[2] = {0, 0}; // seconds
    bool mButtons[2][2] = {{false, false}, {false, false}};
};

} // namespace ductus
