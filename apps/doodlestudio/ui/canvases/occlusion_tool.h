// OcclusionTool: the brush that says, against what the depth says, where the chosen canvas is seen and where
// it is hidden.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"
#include "doodlestudio/ui/player/player_tool.h"

namespace ductus {

class OcclusionTool : public PlayerTool
{
public:
    explicit OcclusionTool(StudioState &state) : mState(state) {}

    /// Whether the canvas comes in front of what is brushed, or behind it.
    void setInFront(bool inFront) { mIsInFront = inFront; }

    void paint(QPainter &painter, const PlayerView &view) override;
    void press(const PointerState &pointer, PlayerView &view) override;
    void drag(const PointerState &pointer, PlayerView &view) override;
    void release(const PointerState &pointer, PlayerView &view) override;
    void cancel(PlayerView &view) override;
    void hover(const PointerState &pointer, PlayerView &view) override;
    void leave(PlayerView &view) override;

private:
    double radius() const; // working pixels

    StudioState &mState;
    bool mIsInFront = true;
    bool mIsBrushing = false;
    std::vector<Vec2> mLine; // working pixels
    std::optional<QPointF> mPointer;
};

} // namespace ductus
