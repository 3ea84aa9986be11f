// TransformTool: moves, turns and scales the chosen strokes by a gizmo in the view.
#pragma once

#include "layerpainter/ui/view/painting_view.h"

namespace ductus {

/// A drag moves the chosen strokes in the plane that faces the eye; on the ring it turns them around the view
/// (with Shift around the vertical), on the square it scales them. With a layer or group armed in the
/// timeline it does so with all of it, as a key of its motion at the present time.
class TransformTool : public CanvasTool
{
public:
    explicit TransformTool(PaintingDocument &document) : mDocument(document) {}
    void press(PaintingView &view, const CanvasPointer &pointer) override;
    void move(PaintingView &view, const CanvasPointer &pointer) override;
    void release(PaintingView &view, const CanvasPointer &pointer) override;
    bool cancel(PaintingView &view) override;
    void draw(PaintingView &view, QPainter &painter) override;
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

    /// Where the handles are, for tests: on the ring and on the square.
    static QPointF ringHandle(const QPointF &centre);
    static QPointF scaleHandle(const QPointF &centre);
    /// The middle of what is chosen; nothing without a choice.
    std::optional<Vec3> centre(PaintingView &view) const;

private:
    enum class Grip { Move, Turn, Scale };
    Placement change(PaintingView &view, const CanvasPointer &pointer) const;
    /// None where the pointer has come back to where it was.
    std::optional<PaintingAction> action(PaintingView &view, const CanvasPointer &pointer) const;
    act::Transform transform(PaintingView &view, const Placement &change) const;
    std::vector<ElementId> moved(const PaintingView &view) const;

    PaintingDocument &mDocument;
    Grip mGrip = Grip::Move;
    std::optional<Vec3> mFrom; // where the drag began, while it lasts
    Vec3 mCentre = Vec3::Zero();
    QPointF mPressed;
    mutable std::vector<ElementId> mKnown; // whose middle is kept
    mutable std::shared_ptr<const Painting> mKnownOf;
    mutable double mKnownAt = 0; // second
    mutable Vec3 mMiddle = Vec3::Zero();
};

} // namespace ductus
