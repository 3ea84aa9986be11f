#include "painting/edit/cut_edits.h"

#include "painting/edit/refusal.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Cutting the stroke";

PaintedPoint pointAt(const StrokeShape &stroke, double place)
{
    const std::size_t i = std::min(std::size_t(place), stroke.points.size() - 1);
    const float t = float(place - double(i));
    if (t <= 0 || i + 1 >= stroke.points.size())
        return stroke.points[i];
    const PaintedPoint &a = stroke.points[i], &b = stroke.points[i + 1];
    const Eigen::Vector3f normal = (1 - t) * a.normal + t * b.normal;
    return {(1 - t) * a.position + t * b.position,
            normal.norm() > 1e-6f ? Eigen::Vector3f(normal.normalized()) : a.normal,
            (1 - t) * a.halfWidth + t * b.halfWidth, (1 - t) * a.colour + t * b.colour,
            (1 - t) * a.opacity + t * b.opacity};
}

std::shared_ptr<const ElementShape> part(const StrokeShape &stroke, double from, double to)
{
    StrokeShape piece;
    piece.section = stroke.section;
    piece.points.push_back(pointAt(stroke, from));
    for (double i = std::floor(from) + 1; i < to; ++i)
        piece.points.push_back(stroke.points[std::size_t(i)]);
    piece.points.push_back(pointAt(stroke, to));
    return std::make_shared<const ElementShape>(std::move(piece));
}

struct Place
{
    Layer *layer = nullptr;
    Drawing *drawing = nullptr;
    std::size_t index = 0;
};

Place find(Painting &painting, ElementId id)
{
    for (const Layer *found : std::as_const(painting).layers()) {
        Layer *layer = painting.findLayer(found->id);
        for (Drawing &drawing : layer->drawings)
            for (std::size_t i = 0; i < drawing.elements.size(); ++i)
                if (drawing.elements[i].id == id)
                    return {layer, &drawing, i};
    }
    return {};
}

} // namespace

Result<AddedElements> cutStroke(const Painting &painting, ElementId element,
                                const std::vector<std::pair<double, double>> &kept)
{
    AddedElements result{painting, {}};
    const Place place = find(result.painting, element);
    if (!place.layer)
        return refusal(attempted, "the stroke is not in the painting", "Choose it again");
    if (place.layer->locked)
        return lockedLayer(attempted, *place.layer);
    const Element old = place.drawing->elements[place.index];
    const auto *stroke = std::get_if<StrokeShape>(old.shape.get());
    if (!stroke)
        return refusal(attempted, "it is a mesh", "Remove it as a whole");
    double end = 0;
    std::vector<Element> pieces;
    for (const auto &[from, to] : kept) {
        // not (..) refuses what is not a number, too
        if (!(from >= end && to > from && to <= double(stroke->points.size()) - 1))
            return refusal(attempted, "the parts to keep are not in order along the stroke",
                           "Give them from its beginning to its end");
        end = to;
        pieces.push_back({ElementId{result.painting.nextId++}, old.placement, part(*stroke, from, to)});
        result.elements.push_back(pieces.back().id);
    }
    std::vector<Element> &elements = place.drawing->elements;
    elements.erase(elements.begin() + std::ptrdiff_t(place.index));
    elements.insert(elements.begin() + std::ptrdiff_t(place.index), pieces.begin(), pieces.end());
    for (MotionGroup &group : result.painting.motionGroups) {
        const auto found = std::ranges::find(group.elements, element);
        if (found == group.elements.end())
            continue;
        const auto at = group.elements.erase(found);
        group.elements.insert(at, result.elements.begin(), result.elements.end());
    }
    return result;
}

} // namespace ductus
