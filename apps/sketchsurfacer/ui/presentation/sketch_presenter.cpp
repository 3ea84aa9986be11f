#include "sketchsurfacer/ui/presentation/sketch_presenter.h"

#include <algorithm>
#include <unordered_set>

namespace ductus {

namespace {

constexpr std::size_t mostKept = 24; // about 6 MB each
constexpr Rgba selectedColour{255, 196, 64, 255};

using ViewPointerToResult = std::shared_ptr<const ResultView>;

std::vector<Rgba> deviationColours(const std::vector<double> &distances, double largest)
{
    std::vector<Rgba> colours;
    for (double d : distances)
        colours.push_back(deviationColour(d / largest));
    return colours;
}

} // namespace

Rgba roleColour(StrokeRole role, bool dark)
{
    switch (role) {
    case StrokeRole::Surface:
        return dark ? Rgba{198, 208, 224, 255} : Rgba{52, 64, 98, 255};
    case StrokeRole::Boundary:
        return dark ? Rgba{255, 158, 66, 255} : Rgba{204, 98, 0, 255};
    case StrokeRole::Ignored:
        return dark ? Rgba{92, 98, 108, 255} : Rgba{176, 182, 190, 255};
    case StrokeRole::Inner:
        return dark ? Rgba{196, 146, 255, 255} : Rgba{124, 66, 196, 255};
    case StrokeRole::Skeletal:
        return dark ? Rgba{70, 204, 190, 255} : Rgba{0, 128, 118, 255};
    }
    return {};
}

Rgba foundBorderColour(bool dark)
{
    const Rgba surface = roleColour(StrokeRole::Surface, dark),
               border = roleColour(StrokeRole::Boundary, dark);
    Rgba between{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i)
        between[i] = std::uint8_t((surface[i] + border[i]) / 2);
    return between;
}

Rgba scribbleColour(ScribbleKind kind)
{
    switch (kind) {
    case ScribbleKind::NewRegion:
        return {255, 205, 40, 255};
    case ScribbleKind::Merge:
        return {66, 196, 106, 255};
    case ScribbleKind::Seam:
        return {235, 68, 68, 255};
    case ScribbleKind::ForbidSeam:
        return {120, 170, 255, 255};
    case ScribbleKind::Split:
        return {255, 140, 60, 255};
    case ScribbleKind::Lock:
    case ScribbleKind::SetDegree:
        break;
    }
    return {230, 232, 236, 255};
}

SketchPresenter::SketchPresenter(SketchDocument &document, JobRunner &runner, SketchView &view,
                                 QObject *parent)
    : QObject(parent), mDocument(document), mRunner(runner), mView(view)
{
    connect(&document, &Document::changed, this, &SketchPresenter::onChanged);
    connect(&view, &SketchView::modeChanged, this, &SketchPresenter::showStrokes);
}

void SketchPresenter::onChanged(const ChangeEvent &event)
{
    if (event.as<DocumentReset>()) {
        mRunner.cancelKey(QStringLiteral("view"));
        mKept.clear();
        mShown = nullptr;
        mPalette = std::make_shared<RegionPalette>();
        mSelection.clear();
        for (const SceneItem item :
             {SceneItem::Proxy, SceneItem::Regions, SceneItem::Surface, SceneItem::Deviation})
            mView.setMesh(item, {});
        mView.setCreases({});
        mView.forgetFraming();
        showExtent();
        showStrokes();
        showScribbles();
        showResult();
        emit resultShown();
    } else if (const auto *change = event.as<SketchChanged>()) {
        if (change->strokes) {
            showExtent();
            showStrokes();
        }
        if (change->scribbles)
            showScribbles();
    } else if (event.as<ResultChanged>()) {
        showResult();
    }
}

void SketchPresenter::showExtent()
{
    const StrokeSet &strokes = mDocument.strokes();
    mView.setExtent(strokes.box(), strokes.upAxis, strokes.metresPerUnit);
    if (!mShown)
        mView.setGround(groundShadow(strokes.allPoints(), strokes.upAxis, 0.24));
}

void SketchPresenter::showStrokes()
{
    const StrokeSet &strokes = mDocument.strokes();
    const DeviationMap *map = mShown && mView.mode() == ViewMode::Deviation ? &mShown->deviationMap : nullptr;
    std::vector<ViewLine> lines;
    std::vector<StrokeId> chosen = mSelection; // of a cloud of points it may be thousands
    const auto byValue = [](StrokeId a, StrokeId b) { return a.value < b.value; };
    std::sort(chosen.begin(), chosen.end(), byValue);
    std::unordered_set<int> found;
    for (StrokeId id : foundBorders())
        found.insert(id.value);
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
        const Stroke &stroke = strokes.strokes[i];
        ViewLine line;
        line.points = stroke.points;
        line.colours = {roleColour(stroke.role, mDark)};
        line.coloursOnMesh = {stroke.role == StrokeRole::Surface ? Rgba{44, 54, 86, 255}
                                                                 : roleColour(stroke.role, false)};
        if (found.count(stroke.id.value) > 0) {
            line.colours = {mBordersPointedOut ? roleColour(StrokeRole::Boundary, mDark)
                                               : foundBorderColour(mDark)};
            line.coloursOnMesh = {mBordersPointedOut ? roleColour(StrokeRole::Boundary, false)
                                                     : foundBorderColour(false)};
            line.width = mBordersPointedOut ? 1.8 : 1.0;
        }
        if (map && i < map->strokeDistance.size() && map->strokeDistance[i].size() == stroke.points.size()) {
            line.coloursOnMesh = deviationColours(map->strokeDistance[i], map->largest);
            line.width = 1.25;
        }
        if (stroke.role == StrokeRole::Ignored)
            line.width = 0.6;
        if (std::binary_search(chosen.begin(), chosen.end(), stroke.id, byValue)) {
            line.colours = line.coloursOnMesh = {selectedColour};
            line.width = 1.5;
        }
        lines.push_back(std::move(line));
    }
    mView.setStrokes(lines);
}

void SketchPresenter::showScribbles()
{
    std::vector<ViewLine> lines;
    for (const Scribble &scribble : mDocument.content().scribbles) {
        if (scribble.kind == ScribbleKind::Lock || scribble.kind == ScribbleKind::SetDegree)
            continue; // told by the region list
        lines.push_back({scribble.points, {scribbleColour(scribble.kind)}, {}, 1.0});
    }
    mView.setScribbles(lines);
}

void SketchPresenter::showResult()
{
    const std::shared_ptr<const SurfacingState> state = mDocument.shownResult();
    if (!state) {
        if (std::exchange(mShown, nullptr))
            emit resultShown();
        return;
    }
    for (const ViewPointerToResult &kept : mKept)
        if (kept->state == state) {
            mRunner.cancelKey(QStringLiteral("view"));
            adopt(kept);
            return;
        }
    auto work = [state, strokes = mDocument.content().strokes, palette = mPalette](
                    const JobControl &control) { return makeResultView(state, *strokes, *palette, control); };
    auto finish = [this, state](Result<ViewPointerToResult> view) {
        if (!view)
            return; // cancelled: a newer one is being made
        if (!(*view)->isPreview) {
            mKept.push_back(*view);
            if (mKept.size() > mostKept)
                mKept.pop_front();
        }
        if (mDocument.shownResult() == state)
            adopt(*view);
    };
    mRunner.start<ViewPointerToResult>({QStringLiteral("view"), tr("Drawing the surface"), true}, this, work,
                                       finish);
}

void SketchPresenter::adopt(std::shared_ptr<const ResultView> view)
{
    mShown = std::move(view);
    if (mShown->proxy.mesh)
        mView.setMesh(SceneItem::Proxy, mShown->proxy);
    if (mShown->regions.mesh)
        mView.setMesh(SceneItem::Regions, mShown->regions);
    if (!mShown->isPreview) { // the old surface stays until the new one is there
        mView.setMesh(SceneItem::Surface, mShown->surface);
        mView.setMesh(SceneItem::Deviation, mShown->deviation);
        mView.setCreases(mShown->creases);
    }
    mView.setGround(mShown->shadow);
    ColourLegend legend;
    legend.title = tr("Strokes to surface");
    for (int i = 0; i <= 16; ++i)
        legend.colours.push_back(deviationColour(i / 16.0));
    legend.largestMetres = mShown->deviationMap.largest * mDocument.strokes().metresPerUnit;
    if (!mShown->isPreview)
        mView.overlay().setLegend(legend);
    showStrokes();
    emit resultShown();
}

int SketchPresenter::regionOf(const RayHit &hit) const
{
    const ViewMesh &picked = mView.pickMesh();
    if (!mShown || picked.mesh != mShown->regions.mesh || hit.triangle < 0 ||
        hit.triangle >= int(mShown->triangleRegions.size()))
        return -1;
    return mShown->triangleRegions[std::size_t(hit.triangle)];
}

void SketchPresenter::setSelection(std::vector<StrokeId> strokes)
{
    if (strokes == mSelection)
        return;
    mSelection = std::move(strokes);
    showStrokes();
    emit selectionChanged();
}

StrokeId SketchPresenter::strokeId(int lineIndex) const
{
    const std::vector<Stroke> &strokes = mDocument.strokes().strokes;
    return lineIndex >= 0 && lineIndex < int(strokes.size()) ? strokes[std::size_t(lineIndex)].id
                                                             : StrokeId();
}

int SketchPresenter::lineOf(StrokeId stroke) const
{
    const std::vector<Stroke> &strokes = mDocument.strokes().strokes;
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (strokes[i].id == stroke)
            return int(i);
    return -1;
}

std::vector<StrokeId> SketchPresenter::foundBorders() const
{
    std::vector<StrokeId> found;
    if (!mShown || mShown->foundBorders.empty())
        return found;
    std::unordered_set<int> ids;
    for (StrokeId id : mShown->foundBorders)
        ids.insert(id.value);
    for (const Stroke &stroke : mDocument.strokes().strokes)
        if (stroke.role == StrokeRole::Surface && ids.count(stroke.id.value) > 0)
            found.push_back(stroke.id);
    return found;
}

void SketchPresenter::setBordersPointedOut(bool on)
{
    if (on == mBordersPointedOut)
        return;
    mBordersPointedOut = on;
    showStrokes();
}

void SketchPresenter::setDark(bool dark)
{
    mDark = dark;
    mView.setDark(dark);
    showStrokes();
}

} // namespace ductus
