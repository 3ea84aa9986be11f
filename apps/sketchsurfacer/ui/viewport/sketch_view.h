// SketchView: the canvas of SketchSurfacer. Plain setters for what is shown, camera by mouse and keys,
// picking for the tools. Scene units throughout; positions in logical pixels.
#pragma once

#include "geometry/inspection/ray_tree.h"
#include "sketchsurfacer/ui/viewport/sketch_scene.h"
#include "sketchsurfacer/ui/viewport/view_overlay.h"
#include "sketchsurfacer/ui/viewport/view_tool.h"
#include "sketchsurfacer/ui/viewport/vtk_widget.h"
#include "strokes/stroke.h"

#include <QTimer>
#include <QVariantAnimation>
#include <memory>
#include <optional>

namespace ductus {

enum class ViewMode { Sketch, Proxy, Regions, Surface, Deviation };
inline constexpr int viewModeCount = 5;

/// A mesh ready to be drawn and picked; made on a worker.
struct ViewMesh
{
    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const RayTree> tree;
    ShadedMesh shaded;
};

/// A stroke as it is to look; one of a single point is a dot, whatever its width.
struct ViewLine
{
    std::vector<Vec3> points;
    std::vector<Rgba> colours;       // one a point, or one
    std::vector<Rgba> coloursOnMesh; // the same where a mesh is shown, too; empty: as colours
    double width = 1.0;              // times the usual
};

class SketchView : public VtkWidget
{
    Q_OBJECT
public:
    explicit SketchView(QWidget *parent = nullptr);
    ~SketchView() override;

    // What is shown.
    void setExtent(const Box3 &box, UpAxis up, double metresPerUnit);
    void setStrokes(const std::vector<ViewLine> &lines);
    void setScribbles(const std::vector<ViewLine> &lines);
    /// \a item: Proxy, Regions, Surface, Deviation or Ambiguity; a mesh without triangles empties it.
    void setMesh(SceneItem item, const ViewMesh &mesh);
    void setCreases(const std::vector<std::vector<Vec3>> &lines);
    void setGround(const GroundShadow &shadow);
    void setMode(ViewMode mode);
    ViewMode mode() const { return mMode; }
    bool hasMesh(SceneItem item) const { return mScene.has(item); }
    void setStrokesShown(bool shown);
    /// Also outside the view of the regions.
    void setScribblesShown(bool shown);
    /// In the view of the regions the mesh of SceneItem::Ambiguity instead, as soon as there is one.
    void setAmbiguityShown(bool shown);
    bool isAmbiguityShown() const { return mAmbiguityShown; }
    bool areStrokesShown() const { return mStrokesShown; }
    /// Share of the width left of which the sketch alone is seen; nothing: no comparison.
    void setComparison(std::optional<double> divider);
    std::optional<double> comparison() const { return mDivider; }
    void setDark(bool dark);
    bool isDark() const { return mDark; }
    ViewOverlay &overlay() { return *mOverlay; }

    // Camera.
    const ViewCamera &camera() const { return mCamera; }
    void setPreset(ViewPreset preset);
    void setPerspective(bool on);
    /// All of it is seen.
    void frameAll();
    /// Turns to \a mark, from a side nothing hides it from if there is one, comes near and points it out.
    void showMark(const ViewMark &mark);
    /// True if something was pointed out.
    bool clearMark();
    /// The next extent is framed anew: another sketch.
    void forgetFraming() { mFramed = false; }
    void orbitBy(const QPointF &pixels);
    void zoomBy(double factor);
    /// Around the up axis, 1: a whole round.
    void turnBy(double rounds);
    /// The picture as it is now with smooth edges, in device pixels.
    QImage smoothPicture();
    double metresPerUnit() const { return mMetresPerUnit; }
    Box3 extent() const { return mExtent; }

    // Picking.
    std::optional<RayHit> surfaceAt(const QPointF &position) const;
    /// Index into the lines of setStrokes of the nearest one but \a except within \a reach pixels that
    /// nothing hides, or -1.
    int strokeAt(const QPointF &position, double reach = 9.0, int except = -1) const;
    const std::vector<ViewLine> &strokes() const { return mStrokes; }
    const ViewMesh &pickMesh() const;

    /// Not owned; null: the left button turns the view.
    void setTool(ViewTool *tool);
    ViewTool *tool() const { return mTool; }
    /// Esc: true if the tool had something to forget.
    bool cancelTool();

signals:
    void modeChanged(ductus::ViewMode mode);
    void cameraMoved();
    void comparisonMoved(double divider);

protected:
    void prepareFrame() override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    enum class Drag { None, Tool, Orbit, Pan, Divider };

    SceneItem shownMesh() const;
    void showItems();
    void showStrokeItems();
    void moved();
    double strokeRadius() const;
    void rebuildTubes();
    void buildTubes();
    void drawSmoothly();
    void flyTo(const ViewCamera &camera);

    SketchScene mScene;
    ViewCamera mCamera;
    ViewOverlay *mOverlay = nullptr;
    ViewTool *mTool = nullptr;
    std::vector<ViewLine> mStrokes;
    std::array<ViewMesh, sceneItemCount> mMeshes;
    Box3 mExtent;
    double mMetresPerUnit = 1.0;
    ViewMode mMode = ViewMode::Sketch;
    bool mStrokesShown = true;
    bool mScribblesShown = false;
    bool mAmbiguityShown = false;
    bool mDark = true;
    std::optional<double> mDivider;
    Drag mDrag = Drag::None;
    QPointF mPressed, mLast;
    bool mHasMoved = false;
    bool mFramed = false;
    QTimer mAtRest;
    QVariantAnimation mFlight;
    bool mIsSmooth = false;
    bool mTubesAreOld = false; // built once before the next frame, however much has changed
};

} // namespace ductus
