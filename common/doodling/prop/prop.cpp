#include "doodling/prop/prop.h"

#include "painting/scene/element_placement.h"
#include "project/container/entry_name.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr std::size_t longestLook = 4096;

Box3 boxOf(const Painting &painting)
{
    Box3 box;
    const ElementPlacements placements(painting, 0);
    for (const Stack &stack : painting.stacks)
        for (const Element &element : stack.substrate->drawingAt(0).elements) {
            const Placement place = placements.sceneFromElement(*stack.substrate, element);
            const Eigen::Affine3d matrix = place.matrix();
            if (const auto *stroke = std::get_if<StrokeShape>(element.shape.get())) {
                for (const PaintedPoint &point : stroke->points) {
                    const Vec3 middle = matrix * point.position.cast<double>();
                    const Vec3 reach = Vec3::Constant(place.scale * double(point.halfWidth));
                    box.add(middle - reach);
                    box.add(middle + reach);
                }
            } else {
                for (const Vec3 &vertex : std::get<MeshShape>(*element.shape).mesh.vertices)
                    box.add(matrix * vertex);
            }
        }
    return box;
}

} // namespace

Placement standingOnSheet(const Painting &painting, const Eigen::Vector2d &canvasSize)
{
    Placement placement;
    // Paintings have y up and look towards +z; the sheet has y down and z away.
    placement.rotation = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX());
    const Box3 box = boxOf(painting);
    if (box.isEmpty())
        return placement;
    const Vec3 size = box.max - box.min;
    // Its depth counts as width: turned about, it still fits.
    const double wide = std::max(size.x(), size.z()), high = size.y();
    const double largest = std::max({wide, high, 1e-12});
    placement.scale = std::min(canvasSize.x() / std::max(wide, 1e-3 * largest),
                               canvasSize.y() / std::max(high, 1e-3 * largest));
    const Vec3 foot(box.centre().x(), box.min.y(), box.centre().z());
    placement.translation =
        Vec3(0.0, 0.5 * canvasSize.y(), 0.0) - placement.rotation * (placement.scale * foot);
    return placement;
}

std::optional<LookId> lookNamed(const Painting &painting, const std::string &name)
{
    const auto look = std::ranges::find(painting.looks, name, &Look::name);
    return name.empty() || look == painting.looks.end() ? std::nullopt : std::optional(look->id);
}

bool hasMotion(const Painting &painting)
{
    const auto moves = [](const Layer *layer) {
        return layer->motion.size() > 1 || layer->frames.drawingOfFrame.size() > 1;
    };
    return std::ranges::any_of(painting.layers(), moves) ||
           std::ranges::any_of(painting.motionGroups, [](const MotionGroup &g) { return g.keys.size() > 1; });
}

std::string propProblem(const Prop &prop)
{
    if (!prop.painting)
        return "a prop has no painting";
    if (!prop.placement.isValid() || prop.placement.mirrored)
        return "a prop stands nowhere";
    if (!isValidUtf8(prop.look) || prop.look.size() > longestLook)
        return "the look of a prop has a name that is too long or not UTF-8";
    if (!(prop.framesPerSecond >= 0.0 && prop.framesPerSecond <= 1e6))
        return "a prop moves at no known speed";
    return linkProblem(prop.link);
}

} // namespace ductus
