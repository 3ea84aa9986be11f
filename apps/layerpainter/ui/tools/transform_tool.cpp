#include "layerpainter/ui/tools/transform_tool.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace ductus {

namespace {

constexpr double ringRadius = 64; // pixels
constexpr double reach = 9;       // of a handle, pixels

/// Turned and scaled around a point that stays.
Placement around(const Vec3 &centre, const Eigen::Quaterniond &rotation, double scale)
{
    Placement change;
    change.rotation = rotation;
    change.scale = scale;
    change.translation = centre - scale * (rotation * centre);
    return change;
}

} // namespace

QPointF TransformTool::ringHandle(const QPointF &centre)
{
    return centre + QPointF(0, -ringRadius);
}

QPointF TransformTool::scaleHandle(const QPointF &centre)
{
    return centre + QPointF(ringRadius, ringRadius) * std::sqrt(0.5) * 1.35;
}

std::vector<ElementId> TransformTool::moved(const PaintingView &view) const
{
    return view.keyedThing() ? elementsOf(mDocument.painting(), *view.keyedThing(), view.seconds())
                             : view.selection();
}

std::optional<Vec3> TransformTool::centre(PaintingView &view) const
{
    const std::vector<ElementId> ids = moved(view);
    if (ids.empty())
        return std::nullopt;
    const auto painting = mDocument.sharedPainting();
    if (mKnownOf != painting || mKnown != ids || mKnownAt != view.seconds()) {
        const std::unordered_set<ElementId> chosen(ids.begin(), ids.end());
        Box3 box;
        for (const Layer *layer : painting->layers())
            for (const auto &[element, place] : view.shownElements(*layer)) {
                if (!chosen.contains(element->id))
                    continue;
                if (const auto *stroke = std::get_if<StrokeShape>(element->shape.get()))
                    for (const PaintedPoint &point : stroke->points)
                        box.add(place * point.position.cast<double>());
                else
                    for (const Vec3 &vertex : std::get<MeshShape>(*element->shape).mesh.vertices)
                        box.add(place * vertex);
            }
        mKnown = ids;
        mKnownOf = painting;
        mKnownAt = view.seconds();
        mMiddle = box.isEmpty() ? Vec3(Vec3::Zero()) : box.centre();
    }
    return mMiddle;
}

void TransformTool::press(PaintingView &view, const CanvasPointer &pointer)
{
    mGrip = Grip::Move;
    if (const auto middle = centre(view))
        if (const auto at = view.camera().project(*middle)) {
            const double away = QLineF(*at, pointer.position).length();
            if (QLineF(scaleHandle(*at), pointer.position).length() <= reach)
                mGrip = Grip::Scale;
            else if (std::abs(away - ringRadius) <= reach)
                mGrip = Grip::Turn;
        }
    if (view.selection().empty() && !view.keyedThing()) {
        const auto picked = view.pick(pointer.position);
        if (!picked)
            return;
        view.setSelection({picked->element});
    }
    mCentre = centre(view).value_or(view.camera().pivot());
    mPressed = pointer.position;
    const auto picked = mGrip == Grip::Move ? view.pick(pointer.position) : std::nullopt;
    mFrom = picked ? picked->position
                   : view.camera().onPlane(pointer.position,
                                           mGrip == Grip::Move ? view.camera().pivot() : mCentre);
}

Placement TransformTool::change(PaintingView &view, const CanvasPointer &pointer) const
{
    Placement moved;
    const auto at = view.camera().project(mCentre);
    if (mGrip == Grip::Move || !at) {
        moved.translation = view.camera().onPlane(pointer.position, *mFrom) - *mFrom;
        return moved;
    }
    const QPointF from = mPressed - *at, to = pointer.position - *at;
    if (mGrip == Grip::Scale) {
        const double before = std::hypot(from.x(), from.y()), now = std::hypot(to.x(), to.y());
        return around(mCentre, Eigen::Quaterniond::Identity(), std::clamp(now / before, 0.02, 50.0));
    }
    // Rows of pixels grow downwards: against the clock is positive around what points at the eye.
    const double angle = std::atan2(from.y(), from.x()) - std::atan2(to.y(), to.x());
    const Vec3 axis =
        pointer.modifiers & Qt::ShiftModifier ? Vec3(Vec3::UnitY()) : Vec3(-view.camera().forward());
    return around(mCentre, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)), 1);
}

std::optional<PaintingAction> TransformTool::action(PaintingView &view, const CanvasPointer &pointer) const
{
    const Placement by = change(view, pointer);
    if (by == Placement())
        return std::nullopt;
    const Painting &painting = mDocument.painting();
    if (const PlacementKeys *keys = view.keyedThing() ? keysOf(painting, *view.keyedThing()) : nullptr) {
        const double seconds = loopedTime(view.seconds(), painting.loopSeconds);
        return settingKeys(*view.keyedThing(), withKey(*keys, seconds, by * placementAt(*keys, seconds)));
    }
    return transform(view, by);
}

act::Transform TransformTool::transform(PaintingView &view, const Placement &change) const
{
    act::Transform done{view.selection(), change};
    // Actions change elements inside their layer, which may itself have been moved.
    const Painting &painting = mDocument.painting();
    const double seconds = loopedTime(view.seconds(), painting.loopSeconds);
    for (const Layer *layer : painting.layers())
        for (const Element &element : layer->drawingAt(seconds).elements)
            if (element.id == done.elements.front()) {
                const Eigen::Affine3d motion = placementAt(layer->motion, seconds).matrix();
                if (!motion.isApprox(Eigen::Affine3d::Identity()) && !(done.change == Placement()))
                    done.change = placementOf(motion.inverse() * done.change.matrix() * motion);
                return done;
            }
    return done;
}

void TransformTool::move(PaintingView &view, const CanvasPointer &pointer)
{
    if (!mFrom)
        return;
    const std::optional<PaintingAction> done = action(view, pointer);
    if (!done) {
        view.setPreview(nullptr);
        return;
    }
    Result<PerformedAction> result = performed(mDocument.painting(), *done);
    view.setPreview(result ? std::make_shared<const Painting>(std::move(result->painting)) : nullptr);
}

void TransformTool::release(PaintingView &view, const CanvasPointer &pointer)
{
    if (!mFrom)
        return;
    const std::optional<PaintingAction> done = action(view, pointer);
    mFrom.reset();
    view.setPreview(nullptr);
    if (done)
        (void)mDocument.perform(*done);
}

bool TransformTool::cancel(PaintingView &view)
{
    const bool had = mFrom.has_value();
    mFrom.reset();
    view.setPreview(nullptr);
    return had;
}

void TransformTool::draw(PaintingView &view, QPainter &painter)
{
    const auto middle = mFrom ? std::optional(mCentre) : centre(view);
    const auto at = middle ? view.camera().project(*middle) : std::nullopt;
    if (!at || (mFrom && mGrip == Grip::Move))
        return;
    // Light on dark: seen on paintings of any colour.
    for (const auto &[colour, width] :
         {std::pair(QColor(0, 0, 0, 170), 4.0), std::pair(QColor(255, 255, 255, 235), 1.8)}) {
        painter.setPen(QPen(colour, width));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(*at, ringRadius, ringRadius);
        painter.drawLine(*at, scaleHandle(*at));
    }
    painter.setPen(QPen(QColor(0, 0, 0, 180), 1));
    painter.setBrush(Qt::white);
    painter.drawEllipse(ringHandle(*at), 5, 5);
    painter.drawRect(QRectF(scaleHandle(*at) - QPointF(5, 5), QSizeF(10, 10)));
    painter.drawEllipse(*at, 3, 3);
}

} // namespace ductus
