// The tools of LayerPainter. Each ends in one action of the document; until then the view shows a preview.
#pragma once

#include "layerpainter/ui/view/painting_view.h"

#include <QPolygonF>

namespace ductus {

/// What the next stroke is painted with, and where; shared by tools and panels.
struct BrushState
{
    LayerId layer;          // the active one
    double halfWidth = 0.1; // scene units
    StrokeSection section = StrokeSection::Round;
    Eigen::Vector3f colour{0.35f, 0.12f, 0.6f}; // linear RGB
    bool onSurface = true;                      // else on a plane through the pivot
};

/// A stroke in scene units painted at a moment: into the drawing of \a layer that is shown then, standing
/// where it was painted although the layer may have been moved.
act::Draw drawAction(const Painting &painting, LayerId layer, double seconds, const StrokeShape &stroke);

class PaintTool : public CanvasTool
{
public:
    PaintTool(PaintingDocument &document, const BrushState &brush) : mDocument(document), mBrush(brush) {}
    void press(PaintingView &view, const CanvasPointer &pointer) override;
    void move(PaintingView &view, const CanvasPointer &pointer) override;
    void release(PaintingView &view, const CanvasPointer &pointer) override;
    bool cancel(PaintingView &view) override;
    void draw(PaintingView &view, QPainter &painter) override;

private:
    void add(PaintingView &view, const CanvasPointer &pointer);
    void straighten(PaintingView &view, const CanvasPointer &pointer);
    act::Draw action() const;

    PaintingDocument &mDocument;
    const BrushState &mBrush;
    StrokeShape mStroke;
    std::shared_ptr<const Painting> mBase; // while painting
    double mSeconds = 0;                   // the moment that is painted on
    QPointF mPosition;
    Vec3 mDepth = Vec3::Zero(); // where the stroke last was
};

/// Takes away the strokes of the active layer it touches; with Shift only the touched parts.
class EraseTool : public CanvasTool
{
public:
    EraseTool(PaintingDocument &document, const BrushState &brush) : mDocument(document), mBrush(brush) {}
    void press(PaintingView &view, const CanvasPointer &pointer) override;
    void move(PaintingView &view, const CanvasPointer &pointer) override;
    void release(PaintingView &view, const CanvasPointer &pointer) override;
    bool cancel(PaintingView &view) override;
    void draw(PaintingView &view, QPainter &painter) override;

private:
    void cutParts(PaintingView &view);

    PaintingDocument &mDocument;
    const BrushState &mBrush;
    std::vector<ElementId> mTouched;
    std::vector<QPointF> mPath;
    bool mIsActive = false;
};

/// A click chooses a stroke, Shift adds, a drag from nowhere chooses what lies in the box, with Ctrl what
/// lies inside the drawn line.
class SelectTool : public CanvasTool
{
public:
    SelectTool(PaintingDocument &document, const BrushState &brush) : mDocument(document), mBrush(brush) {}
    void press(PaintingView &view, const CanvasPointer &pointer) override;
    void move(PaintingView &view, const CanvasPointer &pointer) override;
    void release(PaintingView &view, const CanvasPointer &pointer) override;
    bool cancel(PaintingView &view) override;
    void draw(PaintingView &view, QPainter &painter) override;
    Qt::CursorShape cursor() const override { return Qt::ArrowCursor; }

private:
    PaintingDocument &mDocument;
    const BrushState &mBrush;
    bool isInside(const QPointF &position) const;

    std::optional<QRectF> mBox;
    QPolygonF mLasso; // instead of the box, if it has points
};

/// A click asks which layers colour what is there.
class InspectTool : public CanvasTool
{
public:
    void setAsk(std::function<void(const QPointF &)> ask) { mAsk = std::move(ask); }
    void press(PaintingView &, const CanvasPointer &pointer) override { mAsk(pointer.position); }
    void move(PaintingView &, const CanvasPointer &) override {}
    void release(PaintingView &, const CanvasPointer &) override {}

private:
    std::function<void(const QPointF &)> mAsk;
};

/// A drag gives the active appearance layer a gradient: full where it begins, nothing where it ends.
class GradientTool : public CanvasTool
{
public:
    GradientTool(PaintingDocument &document, const BrushState &brush) : mDocument(document), mBrush(brush) {}
    void press(PaintingView &view, const CanvasPointer &pointer) override;
    void move(PaintingView &view, const CanvasPointer &pointer) override;
    void release(PaintingView &view, const CanvasPointer &pointer) override;
    bool cancel(PaintingView &view) override;
    void draw(PaintingView &view, QPainter &painter) override;

private:
    PaintingDocument &mDocument;
    const BrushState &mBrush;
    std::optional<Vec3> mStart;
    Vec3 mEnd = Vec3::Zero();
    bool mIsSpherical = false; // with Shift
};

} // namespace ductus
