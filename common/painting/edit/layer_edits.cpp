#include "painting/edit/layer_edits.h"

#include "painting/edit/refusal.h"

#include <algorithm>

namespace ductus {

namespace {

template <typename T>
void insertAt(std::vector<T> &items, T item, int position)
{
    const bool inside = position >= 0 && position <= int(items.size());
    items.insert(inside ? items.begin() + position : items.end(), std::move(item));
}

template <typename Id>
Id takeId(Painting &painting)
{
    return Id{painting.nextId++};
}

bool masks(const LayerProperties &properties, LayerId layer)
{
    for (const Mask &mask : properties.masks)
        if (const auto *strokes = std::get_if<StrokeMask>(&mask.shape))
            if (strokes->layer == layer)
                return true;
    return false;
}

/// The layer outside \a leaving that is masked by \a layer, in itself or in a look; null if there is none.
const Layer *layerMaskedBy(const Painting &painting, LayerId layer, const std::vector<LayerId> &leaving)
{
    const auto leaves = [&](LayerId id) {
        return std::find(leaving.begin(), leaving.end(), id) != leaving.end();
    };
    for (const Layer *other : painting.layers())
        if (!leaves(other->id) && masks(other->properties, layer))
            return other;
    for (const Look &look : painting.looks)
        for (const auto &[named, properties] : look.layers)
            if (!leaves(named) && masks(properties, layer))
                return painting.findLayer(named);
    return nullptr;
}

/// Why the layers cannot go, if so.
std::optional<Error> keepsLayers(const Painting &painting, const std::vector<LayerId> &leaving,
                                 const char *attempted)
{
    for (const LayerId id : leaving) {
        const Layer &layer = *painting.findLayer(id);
        if (layer.locked)
            return lockedLayer(attempted, layer);
        if (const Layer *masked = layerMaskedBy(painting, id, leaving))
            return refusal(attempted, "its strokes mask the layer \"" + masked->name + "\"",
                           "Remove that mask first", layer.name);
    }
    return std::nullopt;
}

/// Takes references to what is gone out of looks and groups.
void forget(Painting &painting, const std::vector<LayerId> &layers, const std::vector<ElementId> &elements)
{
    for (Look &look : painting.looks)
        std::erase_if(look.layers, [&](const auto &entry) {
            return std::find(layers.begin(), layers.end(), entry.first) != layers.end();
        });
    std::vector<ElementId> sorted = elements;
    std::sort(sorted.begin(), sorted.end());
    for (MotionGroup &group : painting.motionGroups)
        std::erase_if(group.elements,
                      [&](ElementId id) { return std::binary_search(sorted.begin(), sorted.end(), id); });
}

void collect(const Layer &layer, std::vector<LayerId> &layers, std::vector<ElementId> &elements)
{
    layers.push_back(layer.id);
    for (const Drawing &drawing : layer.drawings)
        for (const Element &element : drawing.elements)
            elements.push_back(element.id);
}

/// Changes one layer by \a change; refused if it is missing, or locked, or the change breaks an invariant.
template <typename Change>
Result<Painting> changedLayer(const Painting &painting, LayerId id, const char *attempted, bool evenIfLocked,
                              const Change &change)
{
    Painting changed = painting;
    Layer *layer = changed.findLayer(id);
    if (!layer)
        return noSuchLayer(attempted);
    if (layer->locked && !evenIfLocked)
        return lockedLayer(attempted, *layer);
    change(*layer);
    if (const Result<void> check = checkLayer(changed, *layer); !check)
        return unsound(check.error(), attempted);
    return changed;
}

} // namespace

Result<AddedStack> addStack(const Painting &painting, const std::string &name, int position)
{
    AddedStack added{painting, {}, {}};
    Stack stack;
    stack.id = added.stack = takeId<StackId>(added.painting);
    stack.name = name;
    stack.substrate.emplace();
    stack.substrate->id = added.substrate = takeId<LayerId>(added.painting);
    stack.substrate->name = name;
    insertAt(added.painting.stacks, std::move(stack), position);
    return added;
}

Result<Painting> removeStack(const Painting &painting, StackId stack)
{
    static const char attempted[] = "Removing the stack";
    const Stack *leaving = painting.findStack(stack);
    if (!leaving)
        return refusal(attempted, "there is no such stack", "Choose a stack of this painting");
    if (stack == sceneStackId)
        return refusal(attempted, "every painting has a scene stack", "Remove its layers one by one");
    std::vector<LayerId> layers;
    std::vector<ElementId> elements;
    collect(*leaving->substrate, layers, elements);
    for (const Layer &layer : leaving->appearance)
        collect(layer, layers, elements);
    if (const auto error = keepsLayers(painting, layers, attempted))
        return *error;
    Painting changed = painting;
    std::erase_if(changed.stacks, [&](const Stack &s) { return s.id == stack; });
    forget(changed, layers, elements);
    return changed;
}

Result<Painting> moveStack(const Painting &painting, StackId stack, int position)
{
    static const char attempted[] = "Moving the stack";
    if (stack == sceneStackId)
        return refusal(attempted, "the scene stack stays above all others",
                       "Move its layers to another stack");
    Painting changed = painting;
    const auto found = std::find_if(changed.stacks.begin(), changed.stacks.end(),
                                    [&](const Stack &s) { return s.id == stack; });
    if (found == changed.stacks.end())
        return refusal(attempted, "there is no such stack", "Choose a stack of this painting");
    Stack moved = std::move(*found);
    changed.stacks.erase(found);
    insertAt(changed.stacks, std::move(moved), position);
    return changed;
}

Result<AddedLayer> addAppearanceLayer(const Painting &painting, StackId stack, const std::string &name,
                                      int position)
{
    AddedLayer added{painting, {}};
    Stack *target = added.painting.findStack(stack);
    if (!target)
        return refusal("Adding a layer", "there is no such stack", "Choose a stack of this painting");
    Layer layer;
    layer.id = added.layer = takeId<LayerId>(added.painting);
    layer.name = name;
    insertAt(target->appearance, std::move(layer), position);
    return added;
}

Result<Painting> removeLayer(const Painting &painting, LayerId id)
{
    static const char attempted[] = "Removing the layer";
    const Layer *leaving = painting.findLayer(id);
    if (!leaving)
        return noSuchLayer(attempted);
    if (isSubstrate(painting, id))
        return refusal(attempted, "the layers above colour it", "Remove the whole stack", leaving->name);
    if (const auto error = keepsLayers(painting, {id}, attempted))
        return *error;
    std::vector<LayerId> layers;
    std::vector<ElementId> elements;
    collect(*leaving, layers, elements);
    Painting changed = painting;
    Stack *stack = changed.findStack(painting.stackOf(id)->id);
    std::erase_if(stack->appearance, [&](const Layer &layer) { return layer.id == id; });
    forget(changed, layers, elements);
    return changed;
}

Result<Painting> moveLayer(const Painting &painting, LayerId id, StackId stack, int position)
{
    static const char attempted[] = "Moving the layer";
    const Layer *moving = painting.findLayer(id);
    if (!moving)
        return noSuchLayer(attempted);
    if (isSubstrate(painting, id))
        return refusal(attempted, "a substrate stays with its stack", "Move its strokes, or the stack",
                       moving->name);
    Painting changed = painting;
    Stack *from = changed.findStack(painting.stackOf(id)->id);
    Stack *to = changed.findStack(stack);
    if (!to)
        return refusal(attempted, "there is no such stack", "Choose a stack of this painting", moving->name);
    Layer moved = *moving;
    std::erase_if(from->appearance, [&](const Layer &layer) { return layer.id == id; });
    insertAt(to->appearance, std::move(moved), position);
    return changed;
}

Result<Painting> renameStack(const Painting &painting, StackId stack, const std::string &name)
{
    static const char attempted[] = "Renaming the stack";
    Painting changed = painting;
    Stack *found = changed.findStack(stack);
    if (!found || !found->substrate)
        return refusal(attempted, found ? "the scene has its name" : "there is no such stack",
                       "Choose a stack of this painting");
    found->name = name;
    found->substrate->name = name;
    return changed;
}

Result<AddedLayer> duplicateLayer(const Painting &painting, LayerId layer, const std::string &name)
{
    static const char attempted[] = "Duplicating the layer";
    AddedLayer added{painting, LayerId{painting.nextId}};
    const Layer *original = painting.findLayer(layer);
    if (!original)
        return noSuchLayer(attempted);
    if (isSubstrate(painting, layer))
        return refusal(attempted, "a stack has one substrate", "Duplicate its strokes into another layer",
                       original->name);
    Layer copy = *original;
    copy.id = added.layer;
    copy.name = name;
    copy.locked = false;
    ++added.painting.nextId;
    for (Drawing &drawing : copy.drawings)
        for (Element &element : drawing.elements)
            element.id = ElementId{added.painting.nextId++};
    std::vector<Layer> &layers = added.painting.findStack(painting.stackOf(layer)->id)->appearance;
    const auto at = std::ranges::find(layers, layer, &Layer::id);
    layers.insert(at + 1, std::move(copy));
    return added;
}

Result<Painting> renameLayer(const Painting &painting, LayerId layer, const std::string &name)
{
    return changedLayer(painting, layer, "Renaming the layer", true, [&](Layer &l) { l.name = name; });
}

Result<Painting> setLayerLocked(const Painting &painting, LayerId layer, bool locked)
{
    return changedLayer(painting, layer, "Locking the layer", true, [&](Layer &l) { l.locked = locked; });
}

Result<Painting> setLayerProperties(const Painting &painting, LayerId layer,
                                    const LayerProperties &properties)
{
    return changedLayer(painting, layer, "Changing the layer", false,
                        [&](Layer &l) { l.properties = properties; });
}

Result<Painting> setTolerance(const Painting &painting, LayerId layer, double tolerance, ToleranceMode mode)
{
    return changedLayer(painting, layer, "Changing the tolerance", false, [&](Layer &l) {
        l.tolerance = tolerance;
        l.toleranceMode = mode;
    });
}

Result<Painting> setLayerMotion(const Painting &painting, LayerId layer,
                                const std::vector<PlacementKey> &keys)
{
    return changedLayer(painting, layer, "Changing the motion", false, [&](Layer &l) { l.motion = keys; });
}

} // namespace ductus
