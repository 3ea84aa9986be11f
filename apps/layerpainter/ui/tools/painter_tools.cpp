#include "layerpainter/ui/tools/painter_tools.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double selectReach = 12; // pixels

void drawRing(QPainter &painter, const QPointF &at, double radius)
{
    for (const auto &[colour, width] :
         {std::pair(QColor(0, 0, 0, 140), 3.0), std::pair(QColor(255, 255, 255, 230), 1.2)}) {
        painter.setPen(QPen(colour, width));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, radius, radius);
    }
}

// The place the pointer means: on the painting, or at the depth of \a through.
Vec3 placeAt(PaintingView &view, const QPointF &position, const Vec3 &through)
{
    const auto picked = view.pick(position);
    return picked ? picked->position : view.camera().onPlane(position, through);
}

std::shared_ptr<const Painting> previewOf(const Painting &painting, const PaintingAction &action)
{
    Result<PerformedAction> result = performed(painting, action);
    return result ? std::make_shared<const Painting>(std::move(result->painting)) : nullptr;
}

} // namespace

void PaintTool::press(PaintingView &view, const CanvasPointer &pointer)
{
    mStroke = {};
    mStroke.section = mBrush.section;
    mBase = mDocument.sharedPainting();
    mSeconds = loopedTime(view.seconds(), mBase->loopSeconds);
    mDepth =
        mBrush.onSurface ? placeAt(view, pointer.position, view.camera().pivot()) : view.camera().pivot();
    add(view, pointer);
}

void PaintTool::move(PaintingView &view, const CanvasPointer &pointer)
{
    mPosition = pointer.position;
    if (!mBase)
        return;
    if (pointer.modifiers & Qt::ShiftModifier)
        straighten(view, pointer);
    else
        add(view, pointer);
}

// With Shift the stroke is a straight line from where it began to the pointer.
void PaintTool::straighten(PaintingView &view, const CanvasPointer &pointer)
{
    mStroke.points.resize(1);
    mDepth = mStroke.points.front().position.cast<double>();
    PaintedPoint end = mStroke.points.front();
    const bool growsShape = isSubstrate(*mBase, mBrush.layer);
    const Vec3 at = mBrush.onSurface && !growsShape ? placeAt(view, pointer.position, mDepth)
                                                    : view.camera().onPlane(pointer.position, mDepth);
    end.position = at.cast<float>();
    // As many points as a stroke by hand has, so that the eraser and gradients of width find some.
    constexpr int steps = 16;
    const PaintedPoint begin = mStroke.points.front();
    for (int i = 1; i <= steps; ++i) {
        PaintedPoint between = end;
        between.position = begin.position + float(i) / steps * (end.position - begin.position);
        mStroke.points.push_back(between);
    }
    if (auto preview = previewOf(*mBase, action()))
        view.setPreview(std::move(preview));
}

void PaintTool::add(PaintingView &view, const CanvasPointer &pointer)
{
    // The renderer's last frame shows the stroke itself: of shapes that is painted on, not of colour.
    const bool growsShape = isSubstrate(*mBase, mBrush.layer);
    const bool isFirst = mStroke.points.empty();
    Vec3 at = view.camera().onPlane(pointer.position, mDepth);
    if (mBrush.onSurface && (isFirst || !growsShape))
        at = placeAt(view, pointer.position, mDepth);
    const double halfWidth = mBrush.halfWidth * std::clamp(pointer.pressure, 0.02, 1.0);
    if (!isFirst && (at.cast<float>() - mStroke.points.back().position).norm() < 0.2 * mBrush.halfWidth)
        return;
    mDepth = at;
    mStroke.points.push_back(
        {at.cast<float>(), (-view.camera().forward()).cast<float>(), float(halfWidth), mBrush.colour, 1.f});
    if (auto preview = previewOf(*mBase, action()))
        view.setPreview(std::move(preview));
}

act::Draw drawAction(const Painting &painting, LayerId id, double seconds, const StrokeShape &stroke)
{
    act::Draw draw;
    draw.layer = id;
    if (const Layer *layer = painting.findLayer(id)) {
        draw.drawing = int(&layer->drawingAt(seconds) - layer->drawings.data());
        const Placement motion = placementAt(layer->motion, seconds);
        if (!(motion == Placement()))
            draw.placement = placementOf(motion.matrix().inverse());
    }
    draw.strokes = {std::make_shared<const ElementShape>(stroke)};
    return draw;
}

act::Draw PaintTool::action() const
{
    return drawAction(*mBase, mBrush.layer, mSeconds, mStroke);
}

void PaintTool::release(PaintingView &view, const CanvasPointer &)
{
    if (!mBase)
        return;
    const act::Draw drawn = action();
    mBase = nullptr;
    view.setPreview(nullptr);
    if (!mStroke.points.empty())
        (void)mDocument.perform(drawn); // a refusal is told by the document's signal
}

bool PaintTool::cancel(PaintingView &view)
{
    if (!mBase)
        return false;
    mBase = nullptr;
    view.setPreview(nullptr);
    return true;
}

void PaintTool::draw(PaintingView &view, QPainter &painter)
{
    const Vec3 depth = mBase ? mDepth : view.camera().pivot();
    drawRing(painter, mPosition, std::max(2.0, mBrush.halfWidth / view.camera().unitsPerPixel(depth)));
}

void EraseTool::press(PaintingView &view, const CanvasPointer &pointer)
{
    mTouched.clear();
    mPath.clear();
    mIsActive = true;
    move(view, pointer);
}

void EraseTool::move(PaintingView &view, const CanvasPointer &pointer)
{
    mPath.push_back(pointer.position);
    if (!mIsActive) {
        mPath = {pointer.position};
        return;
    }
    const double reach = std::max(4.0, mBrush.halfWidth / view.camera().unitsPerPixel(view.camera().pivot()));
    const auto found = view.strokeNear(pointer.position, mBrush.layer, reach);
    if (found && std::ranges::find(mTouched, *found) == mTouched.end()) {
        mTouched.push_back(*found);
        view.setSelection(mTouched);
    }
}

void EraseTool::release(PaintingView &view, const CanvasPointer &pointer)
{
    mIsActive = false;
    view.setSelection({});
    if (mTouched.empty())
        return;
    if (pointer.modifiers & Qt::ShiftModifier)
        cutParts(view);
    else
        (void)mDocument.perform(act::Erase{mTouched});
    mTouched.clear();
}

// What of each touched stroke lies farther from the eraser's path than its radius is kept.
void EraseTool::cutParts(PaintingView &view)
{
    const double radius =
        std::max(4.0, mBrush.halfWidth / view.camera().unitsPerPixel(view.camera().pivot()));
    const Layer *layer = mDocument.painting().findLayer(mBrush.layer);
    std::vector<act::Cut> cuts;
    for (const auto &[element, place] : view.shownElements(*layer)) {
        const auto *stroke = std::get_if<StrokeShape>(element->shape.get());
        if (!stroke || std::ranges::find(mTouched, element->id) == mTouched.end())
            continue;
        act::Cut cut;
        cut.element = element->id;
        const double end = double(stroke->points.size()) - 1;
        constexpr double step = 0.125; // of the way between two points
        std::optional<double> begun;
        for (double t = 0; t <= end; t += step) {
            const auto i = std::min(std::size_t(t), stroke->points.size() - 2);
            const Eigen::Vector3f a = stroke->points[i].position, b = stroke->points[i + 1].position;
            const auto at =
                view.camera().project(place * (a + float(t - double(i)) * (b - a)).cast<double>());
            const bool isTouched = at && std::ranges::any_of(mPath, [&](const QPointF &p) {
                                       return QLineF(p, *at).length() <= radius;
                                   });
            if (!isTouched && !begun)
                begun = t;
            if (begun && (isTouched || t + step > end)) {
                const double to = isTouched ? t - step : end;
                if (to > *begun)
                    cut.kept.emplace_back(*begun, to);
                begun.reset();
            }
        }
        cuts.push_back(std::move(cut));
    }
    if (cuts.size() > 1)
        mDocument.undoStack()->beginMacro(QObject::tr("Erase"));
    for (const act::Cut &cut : cuts)
        (void)mDocument.perform(cut);
    if (cuts.size() > 1)
        mDocument.undoStack()->endMacro();
}

bool EraseTool::cancel(PaintingView &view)
{
    if (!mIsActive)
        return false;
    mIsActive = false;
    mTouched.clear();
    view.setSelection({});
    return true;
}

void EraseTool::draw(PaintingView &view, QPainter &painter)
{
    if (!mPath.empty())
        drawRing(painter, mPath.back(),
                 std::max(4.0, mBrush.halfWidth / view.camera().unitsPerPixel(view.camera().pivot())));
}

void SelectTool::press(PaintingView &view, const CanvasPointer &pointer)
{
    mBox.reset();
    std::optional<ElementId> hit;
    // Strokes of an appearance layer are not seen themselves: the active layer's come first.
    if (!isSubstrate(mDocument.painting(), mBrush.layer))
        hit = view.strokeNear(pointer.position, mBrush.layer, selectReach);
    if (!hit) {
        if (const auto picked = view.pick(pointer.position))
            hit = picked->element;
    }
    std::vector<ElementId> chosen;
    if (pointer.modifiers & Qt::ShiftModifier)
        chosen = view.selection();
    if (!hit) {
        mBox = QRectF(pointer.position, QSizeF(0, 0));
        mLasso.clear();
        if (pointer.modifiers & Qt::ControlModifier)
            mLasso << pointer.position;
    } else if (const auto found = std::ranges::find(chosen, *hit); found != chosen.end()) {
        chosen.erase(found);
    } else {
        chosen.push_back(*hit);
    }
    view.setSelection(std::move(chosen));
}

void SelectTool::move(PaintingView &, const CanvasPointer &pointer)
{
    if (!mBox)
        return;
    mBox->setBottomRight(pointer.position);
    if (!mLasso.isEmpty())
        mLasso << pointer.position;
}

bool SelectTool::isInside(const QPointF &position) const
{
    return mLasso.isEmpty() ? mBox->normalized().contains(position)
                            : mLasso.containsPoint(position, Qt::OddEvenFill);
}

void SelectTool::release(PaintingView &view, const CanvasPointer &pointer)
{
    if (!mBox)
        return;
    const QRectF box = mLasso.isEmpty() ? mBox->normalized() : mLasso.boundingRect();
    const Layer *layer = mDocument.painting().findLayer(mBrush.layer);
    if (!layer || box.width() < 3 || box.height() < 3) {
        mBox.reset();
        return;
    }
    std::vector<ElementId> chosen;
    if (pointer.modifiers & Qt::ShiftModifier)
        chosen = view.selection();
    for (const auto &[element, place] : view.shownElements(*layer)) {
        const auto *stroke = std::get_if<StrokeShape>(element->shape.get());
        const auto isMeant = [this, &view, &place = place](const PaintedPoint &point) {
            const auto at = view.camera().project(place * point.position.cast<double>());
            return at && isInside(*at);
        };
        if (stroke && std::ranges::any_of(stroke->points, isMeant) &&
            std::ranges::find(chosen, element->id) == chosen.end())
            chosen.push_back(element->id);
    }
    mBox.reset();
    view.setSelection(std::move(chosen));
}

bool SelectTool::cancel(PaintingView &)
{
    const bool had = mBox.has_value();
    mBox.reset(); // what is chosen stays so for the other tools
    return had;
}

void SelectTool::draw(PaintingView &view, QPainter &painter)
{
    if (!mBox)
        return;
    QColor accent = view.palette().color(QPalette::Highlight);
    painter.setPen(accent);
    accent.setAlpha(40);
    painter.setBrush(accent);
    if (mLasso.isEmpty())
        painter.drawRect(mBox->normalized());
    else
        painter.drawPolygon(mLasso);
}

void GradientTool::press(PaintingView &view, const CanvasPointer &pointer)
{
    mStart = mEnd = placeAt(view, pointer.position, view.camera().pivot());
}

void GradientTool::move(PaintingView &view, const CanvasPointer &pointer)
{
    if (!mStart)
        return;
    mEnd = placeAt(view, pointer.position, *mStart);
    mIsSpherical = pointer.modifiers & Qt::ShiftModifier;
}

void GradientTool::release(PaintingView &, const CanvasPointer &)
{
    if (!mStart)
        return;
    const Vec3 start = *mStart;
    mStart.reset();
    const Layer *layer = mDocument.painting().findLayer(mBrush.layer);
    if (!layer || (mEnd - start).norm() < 1e-9)
        return;
    GradientMask gradient;
    gradient.shape = mIsSpherical ? GradientMask::Shape::Spherical : GradientMask::Shape::Linear;
    gradient.start = start;
    gradient.end = mEnd;
    gradient.easing = MaskEasing::Smooth;
    // A second drag changes the gradient there is; other masks stay.
    std::vector<Mask> masks = layer->properties.masks;
    std::erase_if(masks, [](const Mask &mask) { return std::holds_alternative<GradientMask>(mask.shape); });
    masks.push_back({true, false, gradient});
    act::SetProperties edit;
    edit.layer = mBrush.layer;
    edit.masks = std::move(masks);
    (void)mDocument.perform(edit);
}

bool GradientTool::cancel(PaintingView &)
{
    const bool had = mStart.has_value();
    mStart.reset();
    return had;
}

void GradientTool::draw(PaintingView &view, QPainter &painter)
{
    if (!mStart)
        return;
    const auto from = view.camera().project(*mStart), to = view.camera().project(mEnd);
    if (!from || !to)
        return;
    painter.setPen(QPen(QColor(0, 0, 0, 150), 4));
    painter.drawLine(*from, *to);
    painter.setPen(QPen(Qt::white, 1.6));
    painter.drawLine(*from, *to);
    painter.setBrush(Qt::white);
    painter.drawEllipse(*from, 4, 4);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(*to, 4, 4);
}

} // namespace ductus
