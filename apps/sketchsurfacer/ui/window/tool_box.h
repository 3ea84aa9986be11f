// ToolBox: the tools of the canvas and what they do to the document.
#pragma once

#include "sketchsurfacer/document/sketch_document.h"
#include "sketchsurfacer/ui/presentation/sketch_presenter.h"
#include "sketchsurfacer/ui/tools/draw_stroke_tool.h"
#include "sketchsurfacer/ui/tools/measure_tool.h"
#include "sketchsurfacer/ui/tools/region_click_tool.h"
#include "sketchsurfacer/ui/tools/role_brush.h"
#include "sketchsurfacer/ui/tools/scribble_tool.h"
#include "sketchsurfacer/ui/tools/select_tool.h"

#include <QObject>

namespace ductus {

enum class ToolKind {
    Select,
    RoleBrush,
    DrawStroke,
    NewRegion,
    Merge,
    Seam,
    Split,
    ForbidSeam,
    Lock,
    Measure
};

class ToolBox : public QObject
{
    Q_OBJECT
public:
    /// All must outlive this.
    ToolBox(SketchDocument &document, SketchPresenter &presenter, SketchView &view,
            QObject *parent = nullptr);
    ~ToolBox() override;

    void setTool(ToolKind kind);
    ToolKind tool() const { return mKind; }
    /// One sentence on what to do with it.
    QString hint() const;

    void setBrushRole(StrokeRole role);
    StrokeRole brushRole() const { return mBrushRole; }

    /// Whether drawn strokes come twice where the sketch is symmetric.
    void setMirrors(bool on) { mMirrors = on; }

    /// Of the stroke that is chosen, if it is one and Select the tool.
    std::vector<StrokeHandle> strokeHandles() const
    {
        return mKind == ToolKind::Select ? mSelect.handles().handles(mView) : std::vector<StrokeHandle>();
    }

    /// Locks \a region, or takes its lock away.
    void toggleLock(int region);
    void setDegree(int region, int degree);

signals:
    void toolChanged();
    void regionClicked(int region);
    /// With the arrow, on the surface.
    void surfaceClicked(const QPointF &position);
    /// A tool cannot do anything here yet; \a why in a sentence.
    void refused(const QString &why);
    void measured(double length);

private:
    void clickStroke(int line, bool extend);
    void chooseLines(const std::vector<int> &lines, bool extend);
    void addDrawn(const std::vector<Vec3> &points);
    int regionAt(const QPointF &position) const;
    /// Of the one stroke that is chosen, or -1.
    int lineToBend() const;

    SketchDocument &mDocument;
    SketchPresenter &mPresenter;
    SketchView &mView;
    SelectTool mSelect;
    RoleBrush mBrush;
    DrawStrokeTool mDraw;
    ScribbleTool mScribble;
    RegionClickTool mLock;
    MeasureTool mMeasure;
    ToolKind mKind = ToolKind::Select;
    bool mMirrors = true;
    StrokeRole mBrushRole = StrokeRole::Boundary;
};

} // namespace ductus
