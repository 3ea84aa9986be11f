// PaintingView: the canvas. Draws the painting with common/render, turns, pans and zooms, and hands the left
// button and the pen to the tool.
#pragma once

#include "layerpainter/document/motion_keys.h"
#include "layerpainter/document/painting_document.h"
#include "layerpainter/ui/view/canvas_tool.h"
#include "layerpainter/ui/view/frame_pace.h"
#include "layerpainter/ui/view/paint_camera.h"
#include "layerpainter/ui/view/smooth_still.h"
#include "render/painting_renderer.h"

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <functional>

class QOpenGLFramebufferObject;

namespace ductus {

class PaintingView : public QOpenGLWidget
{
    Q_OBJECT
public:
    explicit PaintingView(PaintingDocument &document, QWidget *parent = nullptr);
    ~PaintingView() override;

    PaintCamera &camera() { return mCamera; }
    /// The painting's camera, or all of it.
    void frameAll();

    /// The moment that is shown. \a followCamera: the view goes along the painting's camera path.
    void setSeconds(double seconds, bool followCamera);
    double seconds() const { return mSeconds; }
    /// Strokes and meshes of \a layer shown at that moment, and where they stand in the scene.
    std::vector<std::pair<const Element *, Eigen::Affine3d>> shownElements(const Layer &layer) const;

    /// What the transform tool moves as a whole, by keys at this moment; none: the chosen strokes.
    void setKeyedThing(std::optional<MovedThing> thing);
    const std::optional<MovedThing> &keyedThing() const { return mKeyed; }

    /// Not owned; null: the left button turns the view.
    void setTool(CanvasTool *tool);
    bool cancelTool();

    /// Shown instead of the document's painting while a tool works; null: the document's.
    void setPreview(std::shared_ptr<const Painting> preview);
    /// What is outlined, and what is traced because the pointer is on its layer's row.
    void setSelection(std::vector<ElementId> selection);
    const std::vector<ElementId> &selection() const { return mSelection; }
    void setHoveredLayer(std::optional<LayerId> layer);
    /// Draws outlines and the tool's marks anew, not the painting.
    void updateMarks();

    /// What is seen there, exact to the pixel of the window however coarse it is drawn; nothing on the
    /// background.
    std::optional<PickedPoint> pick(const QPointF &position);
    /// The stroke of \a layer whose centreline passes nearest within \a reach pixels.
    std::optional<ElementId> strokeNear(const QPointF &position, LayerId layer, double reach);

    /// Draws instead of the painting onto a framebuffer of that size in pixels, in the view's own context;
    /// empty: the painting again. For what a headset shows.
    void setStandIn(std::function<void(unsigned framebuffer, const QSize &size)> draw);

    /// A picture of the painting alone.
    QImage picture();
    int frameCount() const { return mFrameCount; }
    double lastFrameMilliseconds() const { return mLastFrameMilliseconds; }
    /// Window pixels along each side of a pixel of the last frame: 1 unless something moves.
    int lastFrameDivisor() const { return mDrawnDivisor; }
    /// Whether the canvas rests and its edges are smooth.
    bool isSmooth() const { return mSmooth && mSmooth->isOf(stillScene()) && mSmooth->isDone(); }
    /// Frames that take longer stay as they are: the window answers nobody while one is drawn.
    void setMostSmoothenedMilliseconds(double most) { mMostSmoothenedMilliseconds = most; }
    /// The pen's pressure goes through this first.
    void setPressureCurve(std::function<double(double)> curve) { mPressure = std::move(curve); }

signals:
    void graphicsFailed(const ductus::Error &error);
    void selectionChanged();
    void pointerMoved(const QPointF &position);
    void framed();
    void viewMoved();

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void tabletEvent(QTabletEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    class Overlay;
    enum class Drag { None, Tool, Orbit, Pan };

    void releaseGraphics();
    void drawOverlay(QPainter &painter);
    void traceElement(QPainter &painter, const Element &element, const Eigen::Affine3d &place) const;
    void changedView();
    void movedView();
    Result<void> drawFrame(int width, int height, int divisor);
    StillScene stillScene() const;
    void smoothen();

    PaintingDocument &mDocument;
    std::optional<PaintingRenderer> mRenderer;
    std::shared_ptr<const Painting> mUploaded; // what it shows, as of this second
    double mUploadedSeconds = 0;
    PaintCamera mCamera;
    Overlay *mOverlay;
    CanvasTool *mTool = nullptr;
    std::shared_ptr<const Painting> mPreview;
    std::vector<ElementId> mSelection;
    std::optional<LayerId> mHovered;
    std::optional<MovedThing> mKeyed;
    std::function<double(double)> mPressure;
    std::function<void(unsigned, const QSize &)> mStandIn;
    Drag mDrag = Drag::None;
    QPointF mLast;
    double mSeconds = 0;
    int mFrameCount = 0;
    double mLastFrameMilliseconds = 0;
    FramePace mPace;
    QElapsedTimer mClock;
    QTimer mStill; // runs while something moves
    int mDrawnDivisor = 1;
    std::unique_ptr<QOpenGLFramebufferObject> mCoarse; // frames while something moves
    std::unique_ptr<QOpenGLFramebufferObject> mPixel;  // pick() while something moves
    std::unique_ptr<SmoothStill> mSmooth;
    QTimer mSmoothen; // while there is something left to smoothen
    double mMostSmoothenedMilliseconds = 300;
};

} // namespace ductus
