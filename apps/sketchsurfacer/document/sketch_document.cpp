#include "sketchsurfacer/document/sketch_document.h"

#include "document/project_picture.h"
#include "sketchsurfacer/document/edit_content.h"
#include "sketchsurfacer/document/project_conversion.h"

#include <algorithm>
#include <unordered_set>

namespace ductus {

namespace {

// States share their parts; what is new in each is about 5 MB.
constexpr std::size_t mostResults = 40;

// Of a cloud of points thousands may be meant at once.
class IdSet
{
public:
    explicit IdSet(const std::vector<StrokeId> &ids)
    {
        for (StrokeId id : ids)
            mIds.insert(id.value);
    }
    bool contains(StrokeId id) const { return mIds.count(id.value) > 0; }

private:
    std::unordered_set<int> mIds;
};

} // namespace

SketchDocument::SketchDocument(QObject *parent) : Document(parent)
{
    mContent.options = defaultSurfaceOptions();
}

void SketchDocument::start(StrokeSet strokes, const SurfaceOptions &options, const QString &name)
{
    reset();
    mContent.strokes = std::make_shared<const StrokeSet>(std::move(strokes));
    mContent.options = options;
    mContent.id = ++mLastId;
    emit changed(DocumentReset());
    setUntitledName(name);
}

void SketchDocument::setRole(const std::vector<StrokeId> &ids, StrokeRole role, quint64 drag)
{
    const IdSet meant(ids);
    StrokeSet next = strokes();
    bool differs = false;
    for (Stroke &stroke : next.strokes)
        if (meant.contains(stroke.id) && stroke.role != role) {
            stroke.role = role;
            differs = true;
        }
    if (!differs)
        return;
    SketchContent content = mContent;
    content.strokes = std::make_shared<const StrokeSet>(std::move(next));
    edit(tr("Change role of strokes"), std::move(content), drag);
}

void SketchDocument::setOptions(const QString &text, const SurfaceOptions &options, quint64 drag)
{
    SketchContent content = mContent;
    content.options = options;
    if (restartFrom(mContent.options, options) <= SurfacingStage::Segmentation)
        content.reading = nullptr; // the regions are found anew
    if (restartFrom(mContent.options, options) != SurfacingStage::Nothing)
        edit(text, std::move(content), drag);
}

void SketchDocument::addScribble(const Scribble &scribble)
{
    SketchContent content = mContent;
    content.scribbles.push_back(scribble);
    static const std::map<ScribbleKind, const char *> texts = {
        {ScribbleKind::NewRegion, QT_TR_NOOP("New region")},
        {ScribbleKind::Merge, QT_TR_NOOP("Merge regions")},
        {ScribbleKind::Seam, QT_TR_NOOP("Draw seam")},
        {ScribbleKind::ForbidSeam, QT_TR_NOOP("Forbid seam")},
        {ScribbleKind::Split, QT_TR_NOOP("Split region")},
        {ScribbleKind::Lock, QT_TR_NOOP("Lock region")},
        {ScribbleKind::SetDegree, QT_TR_NOOP("Change surface kind")}};
    edit(tr(texts.at(scribble.kind)), std::move(content));
}

void SketchDocument::removeScribble(int index)
{
    if (index < 0 || index >= int(mContent.scribbles.size()))
        return;
    SketchContent content = mContent;
    content.scribbles.erase(content.scribbles.begin() + index);
    edit(tr("Remove scribble"), std::move(content));
}

void SketchDocument::clearScribbles()
{
    if (mContent.scribbles.empty())
        return;
    SketchContent content = mContent;
    content.scribbles.clear();
    edit(tr("Remove all scribbles"), std::move(content));
}

StrokeId SketchDocument::addStroke(const std::vector<Vec3> &points, StrokeRole role)
{
    return addStrokes({points}, role).front();
}

std::vector<StrokeId> SketchDocument::addStrokes(const std::vector<std::vector<Vec3>> &lines, StrokeRole role)
{
    std::vector<Stroke> strokes;
    for (const std::vector<Vec3> &points : lines) {
        Stroke &stroke = strokes.emplace_back();
        stroke.role = role;
        stroke.points = points;
    }
    return append(tr("Draw stroke"), std::move(strokes));
}

std::vector<StrokeId> SketchDocument::pasteStrokes(std::vector<Stroke> strokes)
{
    return append(tr("Paste strokes"), std::move(strokes));
}

std::vector<StrokeId> SketchDocument::append(const QString &text, std::vector<Stroke> added)
{
    StrokeSet next = strokes();
    int free = 0;
    for (const Stroke &other : next.strokes)
        free = std::max(free, other.id.value + 1);
    std::vector<StrokeId> ids;
    for (Stroke &stroke : added) {
        stroke.id.value = free++;
        ids.push_back(stroke.id);
        next.strokes.push_back(std::move(stroke));
    }
    SketchContent content = mContent;
    content.strokes = std::make_shared<const StrokeSet>(std::move(next));
    edit(text, std::move(content));
    return ids;
}

void SketchDocument::moveStrokes(const std::vector<StrokeId> &ids, const Vec3 &way)
{
    const IdSet meant(ids);
    StrokeSet next = strokes();
    int moved = 0;
    for (Stroke &stroke : next.strokes)
        if (meant.contains(stroke.id)) {
            for (Vec3 &p : stroke.points)
                p += way;
            ++moved;
        }
    if (moved == 0 || way.isZero(0.0))
        return;
    SketchContent content = mContent;
    content.strokes = std::make_shared<const StrokeSet>(std::move(next));
    edit(moved == 1 ? tr("Move stroke") : tr("Move %n strokes", nullptr, moved), std::move(content));
}

void SketchDocument::bendStroke(StrokeId id, const StrokeBend &bend)
{
    StrokeSet next = strokes();
    const auto stroke =
        std::find_if(next.strokes.begin(), next.strokes.end(), [&](const Stroke &s) { return s.id == id; });
    if (stroke == next.strokes.end())
        return;
    Stroke bent = bentStroke(*stroke, bend);
    if (bent.points == stroke->points)
        return;
    *stroke = std::move(bent);
    SketchContent content = mContent;
    content.strokes = std::make_shared<const StrokeSet>(std::move(next));
    edit(tr("Bend stroke"), std::move(content));
}

std::optional<SymmetryPlane> SketchDocument::symmetryPlane() const
{
    if (mContent.options.symmetry == SymmetryMode::Given)
        return mContent.options.symmetryPlane;
    if (mContent.options.symmetry == SymmetryMode::Auto && mShown && mShown->surface &&
        mShown->surface->symmetry)
        return mShown->surface->symmetry->plane;
    return std::nullopt;
}

void SketchDocument::deleteStrokes(const std::vector<StrokeId> &ids)
{
    const IdSet meant(ids);
    StrokeSet next = strokes();
    const auto removed = std::erase_if(next.strokes, [&](const Stroke &s) { return meant.contains(s.id); });
    if (removed == 0)
        return;
    SketchContent content = mContent;
    content.strokes = std::make_shared<const StrokeSet>(std::move(next));
    edit(removed == 1 ? tr("Delete stroke") : tr("Delete %n strokes", nullptr, int(removed)),
         std::move(content));
}

void SketchDocument::setGivenProxy(std::shared_ptr<const TriangleMesh> proxy)
{
    if (proxy == mContent.givenProxy)
        return;
    SketchContent content = mContent;
    content.givenProxy = std::move(proxy);
    content.reading = nullptr;
    const QString text = content.givenProxy ? tr("Use proxy from file") : tr("Make proxy automatically");
    edit(text, std::move(content));
}

void SketchDocument::setUnit(double metresPerUnit, UpAxis up)
{
    if (metresPerUnit == strokes().metresPerUnit && up == strokes().upAxis)
        return;
    StrokeSet next = strokes();
    next.metresPerUnit = metresPerUnit;
    next.upAxis = up;
    SketchContent content = mContent;
    content.strokes = std::make_shared<const StrokeSet>(std::move(next));
    edit(tr("Change unit"), std::move(content));
}

void SketchDocument::chooseReading(std::shared_ptr<const SurfacingState> labelled)
{
    SketchContent content = mContent;
    content.reading =
        std::make_shared<const ChosenReading>(ChosenReading{std::move(labelled), mContent.strokes});
    content.scribbles.clear();
    edit(tr("Choose another surface"), std::move(content));
}

void SketchDocument::startAnew()
{
    SketchContent content = mContent;
    content.reading = nullptr;
    content.startsAnewFrom = mLastId + 1; // the id it is about to get
    edit(tr("Surface anew"), std::move(content));
}

void SketchDocument::edit(const QString &text, SketchContent next, quint64 drag)
{
    next.id = ++mLastId;
    undoStack()->push(new EditContent(text, mContent, std::move(next), drag,
                                      [this](const SketchContent &content) { apply(content); }));
}

void SketchDocument::apply(const SketchContent &content)
{
    SketchChanged event;
    event.strokes = content.strokes != mContent.strokes;
    event.options = restartFrom(mContent.options, content.options) != SurfacingStage::Nothing;
    event.scribbles = content.scribbles != mContent.scribbles;
    event.proxy = content.givenProxy != mContent.givenProxy;
    mContent = content;
    emit changed(event);
    if (isUpToDate())
        showResult();
}

const SketchDocument::Kept *SketchDocument::kept(std::uint64_t contentId) const
{
    for (const Kept &entry : mResults)
        if (entry.content.id == contentId)
            return &entry;
    return nullptr;
}

std::shared_ptr<const SurfacingState> SketchDocument::result() const
{
    const Kept *found = kept(mContent.id);
    return found ? found->state : nullptr;
}

// Of the results of this very input the one that shares most scribbles; the youngest of equals.
const SketchDocument::Kept *SketchDocument::keptOfSameInput() const
{
    const Kept *best = nullptr;
    std::ptrdiff_t mostShared = -1;
    for (const Kept &entry : mResults) {
        if (!entry.state->isPrepared() || entry.content.id < mContent.startsAnewFrom ||
            !hasSameInput(entry.content, mContent))
            continue;
        const std::vector<Scribble> &theirs = entry.content.scribbles;
        const auto differs =
            std::mismatch(theirs.begin(), theirs.end(), mContent.scribbles.begin(), mContent.scribbles.end());
        std::ptrdiff_t shared = differs.first - theirs.begin();
        if (restartFrom(entry.content.options, mContent.options) < SurfacingStage::Segmentation)
            shared = 0;
        if (shared >= mostShared) {
            mostShared = shared;
            best = &entry;
        }
    }
    return best;
}

// The one that is seen, as the user drew on it; else the youngest.
const SketchDocument::Kept *SketchDocument::keptOfOtherStrokes() const
{
    const Kept *best = nullptr;
    for (const Kept &entry : mResults) {
        if (!entry.state->hasLabels() || entry.content.id < mContent.startsAnewFrom ||
            entry.content.givenProxy != mContent.givenProxy ||
            restartFrom(entry.content.options, mContent.options) <= SurfacingStage::Segmentation)
            continue;
        if (!best || best->state != mShown)
            best = &entry;
    }
    return best;
}

std::shared_ptr<const SurfacingState> SketchDocument::startingPoint(SketchContent *madeOf) const
{
    const Kept *best = keptOfSameInput();
    if (!best)
        best = keptOfOtherStrokes();
    if (best && madeOf)
        *madeOf = best->content;
    return best ? best->state : nullptr;
}

void SketchDocument::setResult(const SketchContent &madeOf, std::shared_ptr<const SurfacingState> state)
{
    std::erase_if(mResults, [&](const Kept &entry) { return entry.content.id == madeOf.id; });
    mResults.push_back({madeOf, std::move(state)});
    if (mResults.size() > mostResults)
        mResults.pop_front();
    if (madeOf.id != mContent.id)
        return;
    touch();
    showResult();
}

void SketchDocument::setPreview(std::uint64_t contentId, std::shared_ptr<const SurfacingState> state)
{
    if (contentId != mContent.id)
        return;
    mShown = std::move(state);
    emit changed(ResultChanged());
}

void SketchDocument::dropPreview()
{
    if (!mShown || mShown->hasSurface())
        return;
    mShown = mResults.empty() ? nullptr : mResults.back().state;
    emit changed(ResultChanged());
}

void SketchDocument::showResult()
{
    mShown = result();
    emit changed(ResultChanged());
}

Result<void> SketchDocument::readFrom(const Project &project)
{
    Result<StoredSketch> stored = sketchFromProject(project);
    if (!stored)
        return stored.error();
    clear();
    mDocumentId = stored->documentId;
    mContent = stored->content;
    mContent.id = ++mLastId;
    if (stored->state) {
        mResults.push_back({mContent, stored->state});
        mShown = stored->state;
    }
    return {};
}

void SketchDocument::writeTo(Project &project) const
{
    const std::shared_ptr<const SurfacingState> state = result();
    putSketch(mContent, state.get(), mDocumentId, displayName().toStdString(), project);
    if (!mPicture.isNull())
        setProjectThumbnail(project, mPicture);
}

void SketchDocument::clear()
{
    mContent = SketchContent();
    mContent.options = defaultSurfaceOptions();
    mContent.id = ++mLastId;
    mResults.clear();
    mShown = nullptr;
    mPicture = QImage();
    mDocumentId = Uuid::create();
}

} // namespace ductus
