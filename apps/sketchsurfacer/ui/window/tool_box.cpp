#include "sketchsurfacer/ui/window/tool_box.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double onPlane = 0.015; // of the diagonal: a line along the mirror plane

QColor colourOf(const Rgba &c)
{
    return QColor(c[0], c[1], c[2]);
}

std::optional<ScribbleKind> scribbleOf(ToolKind tool)
{
    switch (tool) {
    case ToolKind::NewRegion:
        return ScribbleKind::NewRegion;
    case ToolKind::Merge:
        return ScribbleKind::Merge;
    case ToolKind::Seam:
        return ScribbleKind::Seam;
    case ToolKind::Split:
        return ScribbleKind::Split;
    case ToolKind::ForbidSeam:
        return ScribbleKind::ForbidSeam;
    default:
        return std::nullopt;
    }
}

// The triangle of \a mesh whose middle is nearest.
int nearestTriangle(const TriangleMesh &mesh, const Vec3 &point)
{
    int best = -1;
    double nearest = 1e300;
    for (int t = 0; t < mesh.triangleCount(); ++t)
        if (const double d = (mesh.centroid(t) - point).squaredNorm(); d < nearest) {
            nearest = d;
            best = t;
        }
    return best;
}

} // namespace

ToolBox::ToolBox(SketchDocument &document, SketchPresenter &presenter, SketchView &view, QObject *parent)
    : QObject(parent), mDocument(document), mPresenter(presenter), mView(view),
      mSelect(
          {[this](int line, bool extend) { clickStroke(line, extend); },
           [this](const QPointF &at) {
               mPresenter.setSelection({});
               emit regionClicked(regionAt(at));
               emit surfaceClicked(at);
           },
           [this] {
               mPresenter.setSelection({});
               emit regionClicked(-1);
           },
           [this](const std::vector<int> &lines, bool extend) { chooseLines(lines, extend); },
           [this](int line) {
               const std::vector<StrokeId> &chosen = mPresenter.selection();
               return std::find(chosen.begin(), chosen.end(), mPresenter.strokeId(line)) != chosen.end();
           },
           [this](const Vec3 &way) { mDocument.moveStrokes(mPresenter.selection(), way); },
           {[this] { return lineToBend(); },
            [this](const StrokeBend &bend) { mDocument.bendStroke(mPresenter.selection().front(), bend); }}}),
      mBrush([this](int line, quint64 drag) {
          mDocument.setRole({mPresenter.strokeId(line)}, mBrushRole, drag);
      }),
      mDraw([this](const std::vector<Vec3> &points) { addDrawn(points); }),
      mScribble(ScribbleKind::NewRegion, Qt::yellow, 1,
                [this](const Scribble &scribble) { mDocument.addScribble(scribble); }),
      mLock([this](const QPointF &at) {
          const int region = regionAt(at);
          if (region >= 0)
              toggleLock(region);
          else
              emit refused(tr("There is no region here. Surface the sketch and click one of its regions."));
      }),
      mMeasure([this](double length) { emit measured(length); })
{
    connect(&presenter, &SketchPresenter::selectionChanged, this, [this] {
        if (mKind == ToolKind::Select)
            emit toolChanged(); // the hint is another
    });
    setBrushRole(mBrushRole);
    setTool(ToolKind::Select);
}

ToolBox::~ToolBox()
{
    mView.setTool(nullptr);
}

void ToolBox::setTool(ToolKind kind)
{
    mKind = kind;
    mView.setScribblesShown(scribbleOf(kind).has_value());
    if (const std::optional<ScribbleKind> scribble = scribbleOf(kind)) {
        const bool isLine = *scribble == ScribbleKind::Seam || *scribble == ScribbleKind::Split ||
                            *scribble == ScribbleKind::ForbidSeam || *scribble == ScribbleKind::Merge;
        mScribble.setKind(*scribble, colourOf(scribbleColour(*scribble)), isLine ? 2 : 1);
        mView.setTool(&mScribble);
    } else if (kind == ToolKind::RoleBrush) {
        mView.setTool(&mBrush);
    } else if (kind == ToolKind::DrawStroke) {
        mView.setTool(&mDraw);
    } else if (kind == ToolKind::Lock) {
        mView.setTool(&mLock);
    } else if (kind == ToolKind::Measure) {
        mView.setTool(&mMeasure);
    } else {
        mView.setTool(&mSelect);
    }
    emit toolChanged();
}

QString ToolBox::hint() const
{
    switch (mKind) {
    case ToolKind::Select:
        if (lineToBend() >= 0)
            return tr(
                "Drag a handle to bend the stroke; with Ctrl it slides over the surface, the wheel widens "
                "the bend. Drag the stroke between handles to move it.");
        return tr("Drag to turn, wheel to zoom. Click a stroke or region to choose it, Shift+drag around "
                  "several; drag chosen "
                  "strokes to move them.");
    case ToolKind::RoleBrush:
        return tr("Paint over strokes to tell what they mean; the role is chosen in the inspector.");
    case ToolKind::DrawStroke:
        return tr("Draw on the surface, or in the air facing you; begin at a stroke to snap to it.");
    case ToolKind::NewRegion:
        return tr("Scribble over what should be a surface of its own.");
    case ToolKind::Merge:
        return tr("Draw from one region into another: they become one smooth surface.");
    case ToolKind::Seam:
        return tr("Draw where two surfaces must meet in a crease.");
    case ToolKind::Split:
        return tr("Draw across a region to cut it in two.");
    case ToolKind::ForbidSeam:
        return tr("Draw along a crease that should not be there.");
    case ToolKind::Lock:
        return tr("Click a region to keep it as it is; click again to free it.");
    case ToolKind::Measure:
        return tr("Click two points to measure between them.");
    }
    return {};
}

void ToolBox::setBrushRole(StrokeRole role)
{
    mBrushRole = role;
    mBrush.setColour(colourOf(roleColour(role, true)));
    emit toolChanged();
}

void ToolBox::clickStroke(int line, bool extend)
{
    const StrokeId id = mPresenter.strokeId(line);
    std::vector<StrokeId> chosen = extend ? mPresenter.selection() : std::vector<StrokeId>();
    const auto found = std::find(chosen.begin(), chosen.end(), id);
    if (found != chosen.end())
        chosen.erase(found);
    else
        chosen.push_back(id);
    mPresenter.setSelection(std::move(chosen));
}

void ToolBox::chooseLines(const std::vector<int> &lines, bool extend)
{
    std::vector<StrokeId> chosen = extend ? mPresenter.selection() : std::vector<StrokeId>();
    for (int line : lines)
        if (const StrokeId id = mPresenter.strokeId(line);
            std::find(chosen.begin(), chosen.end(), id) == chosen.end())
            chosen.push_back(id);
    mPresenter.setSelection(std::move(chosen));
}

void ToolBox::addDrawn(const std::vector<Vec3> &points)
{
    std::vector<std::vector<Vec3>> lines{points};
    if (const std::optional<SymmetryPlane> plane = mDocument.symmetryPlane(); plane && mMirrors) {
        double farthest = 0.0;
        std::vector<Vec3> image;
        for (const Vec3 &p : points) {
            farthest = std::max(farthest, std::abs(plane->signedDistance(p)));
            image.push_back(plane->mirrored(p));
        }
        if (farthest > onPlane * mDocument.strokes().box().diagonal()) // else it is its own image
            lines.push_back(std::move(image));
    }
    mDocument.addStrokes(lines);
}

int ToolBox::lineToBend() const
{
    return mPresenter.selection().size() == 1 ? mPresenter.lineOf(mPresenter.selection().front()) : -1;
}

int ToolBox::regionAt(const QPointF &position) const
{
    const std::optional<RayHit> hit = mView.surfaceAt(position);
    return hit ? mPresenter.regionOf(*hit) : -1;
}

void ToolBox::toggleLock(int region)
{
    const auto view = mPresenter.resultView();
    if (!view || region < 0 || region >= int(view->regionViews.size()))
        return;
    if (!view->regionViews[std::size_t(region)].isLocked) {
        mDocument.addScribble({ScribbleKind::Lock, {view->regionViews[std::size_t(region)].inside}, 0});
        return;
    }
    const std::vector<Scribble> &scribbles = mDocument.content().scribbles;
    for (int i = int(scribbles.size()) - 1; i >= 0; --i) {
        const Scribble &scribble = scribbles[std::size_t(i)];
        if (scribble.kind != ScribbleKind::Lock || scribble.points.empty())
            continue;
        const int t = nearestTriangle(*view->regions.mesh, scribble.points.front());
        if (t >= 0 && view->triangleRegions[std::size_t(t)] == region) {
            mDocument.removeScribble(i);
            return;
        }
    }
}

void ToolBox::setDegree(int region, int degree)
{
    const auto view = mPresenter.resultView();
    if (view && region >= 0 && region < int(view->regionViews.size()))
        mDocument.addScribble(
            {ScribbleKind::SetDegree, {view->regionViews[std::size_t(region)].inside}, degree});
}

} // namespace ductus
