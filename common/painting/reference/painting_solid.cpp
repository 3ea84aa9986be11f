#include "painting/reference/painting_solid.h"

#include "painting/coverage/mask_value.h"
#include "painting/coverage/reach.h"
#include "painting/edit/look_edits.h"

#include <algorithm>
#include <limits>

namespace ductus {

Result<PaintingSolid> PaintingSolid::make(const Painting &painting, const PaintingMoment &moment,
                                          const JobControl &control)
{
    PaintingSolid solid;
    if (moment.look) {
        Result<Painting> changed = applyLook(painting, *moment.look);
        if (!changed) {
            Error error = changed.error();
            error.attempted = "Drawing the painting";
            return error;
        }
        solid.mPainting = std::make_shared<const Painting>(std::move(*changed));
    } else {
        solid.mPainting = std::make_shared<const Painting>(painting);
    }
    const ElementPlacements placements(*solid.mPainting, moment.timeSeconds);
    std::vector<Box3> boxes;
    for (const Stack &stack : solid.mPainting->stacks) {
        if (control.isCancelled())
            return cancelledError("Drawing the painting");
        solid.addStack(stack, placements);
        const LayerSolid *substrate = solid.mStacks.back().substrate;
        boxes.push_back(substrate ? substrate->box() : Box3());
    }
    solid.mStackTree = BoxTree(boxes);
    for (const Layer &layer : solid.mPainting->sceneStack.appearance)
        if (layer.properties.visible && layer.properties.opacity > 0)
            solid.mScene.appearance.push_back(solid.solidOf(layer, placements));
    solid.addMaskLayers(placements);
    solid.addReaches(control);
    if (control.isCancelled())
        return cancelledError("Drawing the painting");
    return solid;
}

LayerSolid *PaintingSolid::solidOf(const Layer &layer, const ElementPlacements &placements)
{
    std::unique_ptr<LayerSolid> &solid = mSolids[layer.id];
    if (!solid)
        solid = std::make_unique<LayerSolid>(layer, layer.properties, placements);
    return solid.get();
}

void PaintingSolid::addStack(const Stack &stack, const ElementPlacements &placements)
{
    StackSolid &solid = mStacks.emplace_back();
    const LayerProperties &properties = stack.substrate->properties;
    if (!properties.visible || properties.opacity <= 0)
        return;
    solid.substrate = solidOf(*stack.substrate, placements);
    for (const Layer &layer : stack.appearance)
        if (layer.properties.visible && layer.properties.opacity > 0)
            solid.appearance.push_back(solidOf(layer, placements));
}

void PaintingSolid::addMaskLayers(const ElementPlacements &placements)
{
    std::vector<const Layer *> masks;
    for (const auto &[id, solid] : mSolids)
        for (const Mask &mask : solid->properties().masks)
            if (const auto *strokes = std::get_if<StrokeMask>(&mask.shape); strokes && mask.enabled)
                masks.push_back(mPainting->findLayer(strokes->layer));
    for (const Layer *layer : masks)
        solidOf(*layer, placements);
}

void PaintingSolid::addReaches(const JobControl &control)
{
    std::vector<const LayerSolid *> all;
    for (const StackSolid &stack : mStacks)
        if (stack.substrate)
            all.push_back(stack.substrate);
    for (const auto &[id, solid] : mSolids) {
        if (!(solid->layer().tolerance > 0) || isSubstrate(*mPainting, id) || control.isCancelled())
            continue;
        const Stack *stack = mPainting->stackOf(id);
        const auto own = stack->substrate ? mSolids.find(stack->substrate->id) : mSolids.end();
        setReach(*solid, own != mSolids.end() ? std::vector<const LayerSolid *>{own->second.get()} : all);
    }
}

void PaintingSolid::surfaces(const Vec3 &origin, const Vec3 &direction, double from,
                             std::vector<SubstratePoint> &points) const
{
    points.clear();
    std::map<int, std::vector<int>> seen; // elements, by stack
    static const std::vector<int> none;
    while (int(points.size()) < mostSurfaces) {
        double limit = std::numeric_limits<double>::infinity();
        std::optional<SkinHit> nearest;
        int stackHit = -1;
        mStackTree.forRay(origin, direction, limit, [&](int stack) {
            const auto hidden = seen.find(stack);
            const auto hit = mStacks[std::size_t(stack)].substrate->hit(
                origin, direction, from, std::nextafter(limit, 1e300),
                hidden == seen.end() ? none : hidden->second);
            if (hit && (hit->s < limit || (hit->s == limit && stack < stackHit))) {
                nearest = hit;
                stackHit = stack;
                limit = hit->s;
            }
            return limit;
        });
        if (!nearest)
            return;
        const LayerSolid &substrate = *mStacks[std::size_t(stackHit)].substrate;
        SubstratePoint point;
        point.position = origin + nearest->s * direction;
        point.depth = nearest->s;
        point.stack = stackHit;
        point.stackId = mPainting->stacks[std::size_t(stackHit)].id;
        point.element = substrate.element(nearest->element).id;
        point.colour = nearest->colour;
        point.opacity = nearest->opacity * substrate.properties().opacity;
        if (point.opacity > 0)
            points.push_back(point);
        if (point.opacity >= 1)
            return;
        std::vector<int> &elements = seen[stackHit];
        elements.insert(std::lower_bound(elements.begin(), elements.end(), nearest->element),
                        nearest->element);
    }
}

LayerColouring PaintingSolid::colouring(const LayerSolid &layer, const Eigen::Vector3d &backdrop,
                                        const Vec3 &x, const Vec3 *view, std::vector<Coating> &coatings) const
{
    LayerColouring colouring;
    colouring.layer = layer.layer().id;
    colouring.result = backdrop;
    layer.coatings(x, view, coatings);
    if (coatings.empty())
        return colouring;
    for (const Coating &coating : coatings) {
        const Eigen::Vector3d straight = toBlendSpace(mPainting->blendSpace, coating.colour.cast<double>());
        colouring.source = over({coating.opacity * straight, coating.opacity}, colouring.source);
        colouring.elements.push_back(layer.element(coating.element).id);
    }
    colouring.opacity = layer.properties().opacity;
    for (const Mask &mask : layer.properties().masks) {
        const auto *strokes = std::get_if<StrokeMask>(&mask.shape);
        const bool covers = strokes && mask.enabled && mSolids.at(strokes->layer)->covers(x, view);
        colouring.opacity *= maskValue(mask, x, covers);
    }
    colouring.result =
        blendOnOpaque(layer.properties().blendMode, backdrop, colouring.source, colouring.opacity);
    return colouring;
}

Eigen::Vector3d PaintingSolid::colour(const SubstratePoint &point, const Vec3 *view) const
{
    Eigen::Vector3d colour = toBlendSpace(mPainting->blendSpace, point.colour.cast<double>());
    std::vector<Coating> coatings;
    for (const StackSolid *stack : {&mStacks[std::size_t(point.stack)], &mScene})
        for (const LayerSolid *layer : stack->appearance)
            colour = colouring(*layer, colour, point.position, view, coatings).result;
    return colour;
}

std::vector<LayerColouring> PaintingSolid::coloursAt(const SubstratePoint &point, const Vec3 *view) const
{
    std::vector<LayerColouring> layers;
    Eigen::Vector3d colour = toBlendSpace(mPainting->blendSpace, point.colour.cast<double>());
    std::vector<Coating> coatings;
    for (const StackSolid *stack : {&mStacks[std::size_t(point.stack)], &mScene})
        for (const LayerSolid *layer : stack->appearance) {
            LayerColouring one = colouring(*layer, colour, point.position, view, coatings);
            colour = one.result;
            if (one.source.alpha * one.opacity > 0)
                layers.push_back(std::move(one));
        }
    std::reverse(layers.begin(), layers.end());
    return layers;
}

} // namespace ductus
