// DirectDrawTool: drawing straight on the player's picture: the line lands on the canvas under it; where
// there is none, one is made.
#pragma once

#include "doodlestudio/ui/drawing/drawing_hand.h"
#include "doodlestudio/ui/player/player_tool.h"

namespace ductus {

class DirectDrawTool : public PlayerTool
{
public:
    DirectDrawTool(StudioState &state, DrawingHand &hand) : mState(state), mHand(hand) {}

    void paint(QPainter &painter, const PlayerView &view) override;
    void press(const PointerState &pointer, PlayerView &view) override;
    void drag(const PointerState &pointer, PlayerView &view) override;
    void release(const PointerState &pointer, PlayerView &view) override;
    void cancel(PlayerView &view) override;
    void hover(const PointerState &pointer, PlayerView &view) override;
    void leave(PlayerView &view) override;

private:
    std::optional<HandPoint> handPoint(const PointerState &pointer) const;
    void makeCanvas(const PointerState &pointer);

    StudioState &mState;
    DrawingHand &mHand;
    std::optional<QPointF> mPointer;
};

} // namespace ductus
