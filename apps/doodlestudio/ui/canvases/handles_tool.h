// HandlesTool: placing and pinning: drag out a new canvas on an empty place; on the chosen one drag its
// middle, its corner (size), its knob (turn) or the gauge figure (tilt); on its trajectory click to go to a
// moment or drag to pin it there.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"
#include "doodlestudio/ui/canvases/trajectory.h"
#include "doodlestudio/ui/player/player_tool.h"

namespace ductus {

class HandlesTool : public QObject, public PlayerTool
{
    Q_OBJECT
public:
    explicit HandlesTool(StudioState &state, QObject *parent = nullptr);

    /// Whether a drag on an empty place makes a canvas.
    void setAdding(bool adds) { mAdds = adds; }

    /// Where the handles of the chosen canvas are, widget pixels.
    struct Handles
    {
        QPointF middle, corner, spin, gauge;
        QPointF topMiddle;
        QPolygonF edge;
        Vec3 front; // towards the camera, camera axes
    };
    std::optional<Handles> handles(const PlayerView &view) const;

    void paint(QPainter &painter, const PlayerView &view) override;
    void press(const PointerState &pointer, PlayerView &view) override;
    void drag(const PointerState &pointer, PlayerView &view) override;
    void release(const PointerState &pointer, PlayerView &view) override;
    void cancel(PlayerView &view) override;
    void hover(const PointerState &pointer, PlayerView &view) override;
    void leave(PlayerView &view) override;

signals:
    void canvasAdded(ductus::CanvasId id);
    /// One sentence on what a press here would do; empty: nothing.
    void hinted(const QString &sentence);

private:
    enum class Part { None, Middle, Corner, Spin, Gauge, Path, Other, Empty };

    Part partAt(const QPointF &inView, const PlayerView &view) const;
    void moveTo(const PointerState &pointer);
    void resizeTo(const PointerState &pointer, const PlayerView &view);
    void spinTo(const PointerState &pointer, const PlayerView &view);
    void tiltTo(const PointerState &pointer);
    void addCanvas(const PointerState &pointer);
    QString sentence(Part part) const;

    StudioState &mState;
    bool mAdds = true;
    Part mPart = Part::None;
    Part mHovered = Part::None;
    std::optional<int> mHoveredFrame;
    quint64 mDrag = 0;
    int mStepsBefore = 0; // of the history, when the drag began
    PointerState mPressed;
    PointerState mNow;
    QPointF mGrip; // from the pointer to the canvas' middle, working pixels
    CanvasFrame mPlaceBefore;
    Vec2 mSizeBefore = Vec2::Zero();
};

} // namespace ductus
