#include "painting/action/action.h"

#include "painting/edit/cut_edits.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/edit/look_edits.h"
#include "painting/edit/scene_edits.h"

namespace ductus {

namespace {

using Outcome = Result<PerformedAction>;

Outcome without(Result<Painting> painting)
{
    if (!painting)
        return painting.error();
    return PerformedAction{std::move(*painting), {}};
}

Outcome with(Result<AddedElements> added)
{
    if (!added)
        return added.error();
    PerformedAction result{std::move(added->painting), {}};
    for (const ElementId id : added->elements)
        result.made.push_back(id.value);
    return result;
}

Outcome with(Result<AddedLayer> added)
{
    if (!added)
        return added.error();
    return PerformedAction{std::move(added->painting), {added->layer.value}};
}

// One overload an action.
struct Performer
{
    const Painting &painting;

    Outcome operator()(const act::AddStack &a) const
    {
        Result<AddedStack> added = addStack(painting, a.name, a.position);
        if (!added)
            return added.error();
        return PerformedAction{std::move(added->painting), {added->stack.value, added->substrate.value}};
    }
    Outcome operator()(const act::RemoveStack &a) const { return without(removeStack(painting, a.stack)); }
    Outcome operator()(const act::MoveStack &a) const
    {
        return without(moveStack(painting, a.stack, a.position));
    }
    Outcome operator()(const act::RenameStack &a) const
    {
        return without(renameStack(painting, a.stack, a.name));
    }
    Outcome operator()(const act::AddLayer &a) const
    {
        return with(addAppearanceLayer(painting, a.stack, a.name, a.position));
    }
    Outcome operator()(const act::RemoveLayer &a) const { return without(removeLayer(painting, a.layer)); }
    Outcome operator()(const act::MoveLayer &a) const
    {
        return without(moveLayer(painting, a.layer, a.stack, a.position));
    }
    Outcome operator()(const act::DuplicateLayer &a) const
    {
        return with(duplicateLayer(painting, a.layer, a.name));
    }
    Outcome operator()(const act::RenameLayer &a) const
    {
        return without(renameLayer(painting, a.layer, a.name));
    }
    Outcome operator()(const act::LockLayer &a) const
    {
        return without(setLayerLocked(painting, a.layer, a.locked));
    }
    Outcome operator()(const act::SetProperties &a) const;
    Outcome operator()(const act::SetTolerance &a) const
    {
        return without(setTolerance(painting, a.layer, a.tolerance, a.mode));
    }
    Outcome operator()(const act::SetLayerMotion &a) const
    {
        return without(setLayerMotion(painting, a.layer, a.keys));
    }
    Outcome operator()(const act::Draw &a) const
    {
        return with(addElements(painting, a.layer, a.strokes, a.drawing, a.placement));
    }
    Outcome operator()(const act::Erase &a) const { return without(removeElements(painting, a.elements)); }
    Outcome operator()(const act::Cut &a) const { return with(cutStroke(painting, a.element, a.kept)); }
    Outcome operator()(const act::MoveElements &a) const
    {
        return without(moveElements(painting, a.elements, a.layer, a.drawing));
    }
    Outcome operator()(const act::Duplicate &a) const;
    Outcome operator()(const act::Transform &a) const
    {
        return without(transformElements(painting, a.elements, a.change));
    }
    Outcome operator()(const act::Recolour &a) const
    {
        return without(recolourElements(painting, a.elements, a.colour));
    }
    Outcome operator()(const act::ReplaceShape &a) const
    {
        return without(replaceShapes(painting, a.elements, a.strokes));
    }
    Outcome operator()(const act::AddLook &a) const
    {
        AddedLook added = addLook(painting, a.name);
        return PerformedAction{std::move(added.painting), {added.look.value}};
    }
    Outcome operator()(const act::UpdateLook &a) const { return without(updateLook(painting, a.look)); }
    Outcome operator()(const act::ApplyLook &a) const { return without(applyLook(painting, a.look)); }
    Outcome operator()(const act::RenameLook &a) const
    {
        return without(renameLook(painting, a.look, a.name));
    }
    Outcome operator()(const act::RemoveLook &a) const { return without(removeLook(painting, a.look)); }
    Outcome operator()(const act::SetScene &a) const
    {
        return without(setScene(painting, a.background.value_or(painting.background),
                                a.blendSpace.value_or(painting.blendSpace),
                                a.loopSeconds.value_or(painting.loopSeconds)));
    }
    Outcome operator()(const act::SetCamera &a) const { return without(setCameraKeys(painting, a.keys)); }
    Outcome operator()(const act::AddGroup &a) const
    {
        Result<AddedGroup> added = addMotionGroup(painting, a.name, a.elements, a.keys);
        if (!added)
            return added.error();
        return PerformedAction{std::move(added->painting), {added->group.value}};
    }
    Outcome operator()(const act::SetGroupMotion &a) const
    {
        return without(setGroupKeys(painting, a.group, a.keys));
    }
    Outcome operator()(const act::RemoveGroup &a) const
    {
        return without(removeMotionGroup(painting, a.group));
    }
};

Outcome Performer::operator()(const act::SetProperties &a) const
{
    const Layer *layer = painting.findLayer(a.layer);
    LayerProperties properties = layer ? layer->properties : LayerProperties();
    properties.visible = a.visible.value_or(properties.visible);
    properties.opacity = a.opacity.value_or(properties.opacity);
    properties.blendMode = a.blend.value_or(properties.blendMode);
    if (a.ownColours.value_or(false))
        properties.colour.reset();
    if (a.colour)
        properties.colour = a.colour;
    if (a.masks)
        properties.masks = *a.masks;
    return without(setLayerProperties(painting, a.layer, properties));
}

Outcome Performer::operator()(const act::Duplicate &a) const
{
    Result<AddedElements> added = duplicateElements(painting, a.elements, a.layer, a.drawing);
    if (added && !(a.change == Placement())) {
        Result<Painting> moved = transformElements(added->painting, added->elements, a.change);
        if (!moved)
            return moved.error();
        added->painting = std::move(*moved);
    }
    return with(std::move(added));
}

} // namespace

std::string_view actionWord(const PaintingAction &action)
{
    return std::visit([](const auto &a) { return a.word; }, action);
}

Result<PerformedAction> performed(const Painting &painting, const PaintingAction &action)
{
    return std::visit(Performer{painting}, action);
}

} // namespace ductus
