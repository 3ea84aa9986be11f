// CanvasLayer: canvases over the player's picture: what is drawn on them, and their edges while they are
// worked on.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"
#include "doodlestudio/ui/player/player_tool.h"

namespace ductus {

class CanvasLayer : public PlayerLayer
{
public:
    explicit CanvasLayer(StudioState &state) : mState(state) {}

    void paint(QPainter &painter, const PlayerView &view) override;
    /// Edges are for working, not for watching.
    void setEdgesVisible(bool visible) { mAreEdgesVisible = visible; }
    /// The picture below has the drawings in it already.
    void setDrawingsVisible(bool visible) { mAreDrawingsVisible = visible; }

private:
    void paintDrawings(QPainter &painter, const PlayerView &view) const;
    void paintEdge(QPainter &painter, const PlayerView &view, const Canvas &canvas) const;

    StudioState &mState;
    bool mAreEdgesVisible = true;
    bool mAreDrawingsVisible = true;
};

} // namespace ductus
