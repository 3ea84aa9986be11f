#include "layerpainter/vr/hands/near_stroke.h"

#include "painting/scene/element_placement.h"

#include <algorithm>

namespace ductus {

namespace {

// The nearest place of a stroke's skin and its colour.
void look(const StrokeShape &stroke, const Eigen::Vector3d &at, double &best, Eigen::Vector3f &colour)
{
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
        const PaintedPoint &a = stroke.points[i],
                           &b = stroke.points[std::min(i + 1, stroke.points.size() - 1)];
        const Eigen::Vector3d from = a.position.cast<double>(), way = b.position.cast<double>() - from;
        const double length = way.squaredNorm();
        const double t = length > 0 ? std::clamp((at - from).dot(way) / length, 0.0, 1.0) : 0;
        const double width = a.halfWidth + t * (b.halfWidth - a.halfWidth);
        const double distance = std::max(0.0, (from + t * way - at).norm() - width);
        if (distance < best) {
            best = distance;
            colour = t < 0.5 ? a.colour : b.colour;
        }
    }
}

} // namespace

std::optional<NearStroke> nearStroke(const Painting &painting, double seconds, const Eigen::Vector3d &point,
                                     double reach, LayerId preferred)
{
    const ElementPlacements placements(painting, seconds);
    std::optional<NearStroke> best;
    for (const Layer *layer : painting.layers()) {
        if (!layer->properties.visible || layer->locked)
            continue;
        for (const Element &element : layer->drawingAt(placements.timeSeconds()).elements) {
            const auto *stroke = std::get_if<StrokeShape>(element.shape.get());
            if (!stroke)
                continue;
            const Placement place = placements.sceneFromElement(*layer, element);
            double distance = std::nextafter(reach, 2 * reach + 1) / place.scale;
            const double limit = distance;
            Eigen::Vector3f colour = Eigen::Vector3f::Zero();
            look(*stroke, place.matrix().inverse() * point, distance, colour);
            if (distance >= limit)
                continue;
            const double inScene = distance * place.scale;
            const bool isPreferred = layer->id == preferred;
            if (!best || inScene < best->distance ||
                (inScene == best->distance && (isPreferred || best->layer != preferred)))
                best = NearStroke{element.id, layer->id, layer->properties.colour.value_or(colour), inScene};
        }
    }
    return best;
}

} // namespace ductus
