#include "painting/edit/element_edits.h"

#include "painting/edit/refusal.h"

#include <unordered_map>
#include <unordered_set>

namespace ductus {

namespace {

using IdSet = std::unordered_set<ElementId>;

template <typename Visit>
void forEachLayer(Painting &painting, const Visit &visit)
{
    for (Stack &stack : painting.stacks) {
        visit(*stack.substrate);
        for (Layer &layer : stack.appearance)
            visit(layer);
    }
    for (Layer &layer : painting.sceneStack.appearance)
        visit(layer);
}

/// Calls \a change for every chosen element; refused if one is missing or in a locked layer.
template <typename Change>
std::optional<Error> changeElements(Painting &painting, const std::vector<ElementId> &elements,
                                    const char *attempted, bool mayBeLocked, const Change &change)
{
    const IdSet chosen(elements.begin(), elements.end());
    std::size_t found = 0;
    std::optional<Error> error;
    forEachLayer(painting, [&](Layer &layer) {
        for (Drawing &drawing : layer.drawings) {
            for (Element &element : drawing.elements) {
                if (!chosen.contains(element.id))
                    continue;
                ++found;
                if (layer.locked && !mayBeLocked && !error)
                    error = lockedLayer(attempted, layer);
                change(element);
            }
        }
    });
    if (error)
        return error;
    if (found != chosen.size())
        return refusal(attempted, "a chosen stroke is not in the painting", "Choose it again");
    return std::nullopt;
}

void erase(Painting &painting, const std::vector<ElementId> &elements)
{
    const IdSet chosen(elements.begin(), elements.end());
    forEachLayer(painting, [&](Layer &layer) {
        for (Drawing &drawing : layer.drawings)
            std::erase_if(drawing.elements,
                          [&](const Element &element) { return chosen.contains(element.id); });
    });
}

/// The drawing to put elements into, or why not.
Result<Drawing *> openDrawing(Painting &painting, LayerId id, int drawing, const char *attempted)
{
    Layer *layer = painting.findLayer(id);
    if (!layer)
        return noSuchLayer(attempted);
    if (layer->locked)
        return lockedLayer(attempted, *layer);
    if (drawing < 0 || drawing >= int(layer->drawings.size()))
        return refusal(attempted, "the layer has no such drawing", "Choose a frame of the layer",
                       layer->name);
    return &layer->drawings[std::size_t(drawing)];
}

std::shared_ptr<const ElementShape> recoloured(const ElementShape &shape, const Eigen::Vector3f &colour)
{
    auto changed = std::make_shared<ElementShape>(shape);
    if (auto *stroke = std::get_if<StrokeShape>(changed.get())) {
        for (PaintedPoint &point : stroke->points)
            point.colour = colour;
    } else {
        for (Eigen::Vector3f &c : std::get<MeshShape>(*changed).vertexColours)
            c = colour;
    }
    return changed;
}

} // namespace

Result<AddedElements> addElements(const Painting &painting, LayerId layer,
                                  const std::vector<std::shared_ptr<const ElementShape>> &shapes, int drawing,
                                  const Placement &placement)
{
    static const char attempted[] = "Adding strokes";
    AddedElements added{painting, {}};
    const Result<Drawing *> target = openDrawing(added.painting, layer, drawing, attempted);
    if (!target)
        return target.error();
    if (!placement.isValid())
        return refusal(attempted, "the placement is not finite or has no scale", "Give a scale above zero");
    for (const auto &shape : shapes) {
        if (!shape)
            return refusal(attempted, "a stroke has no shape", "Give every stroke its points");
        if (const Result<void> check = checkShape(*shape); !check)
            return unsound(check.error(), attempted);
        const ElementId id{added.painting.nextId++};
        (*target)->elements.push_back({id, placement, shape});
        added.elements.push_back(id);
    }
    return added;
}

Result<Painting> removeElements(const Painting &painting, const std::vector<ElementId> &elements)
{
    Painting changed = painting;
    if (const auto error = changeElements(changed, elements, "Removing strokes", false, [](Element &) {}))
        return *error;
    erase(changed, elements);
    const IdSet chosen(elements.begin(), elements.end());
    for (MotionGroup &group : changed.motionGroups)
        std::erase_if(group.elements, [&](ElementId id) { return chosen.contains(id); });
    return changed;
}

Result<Painting> moveElements(const Painting &painting, const std::vector<ElementId> &elements, LayerId layer,
                              int drawing)
{
    static const char attempted[] = "Moving strokes to a layer";
    Painting changed = painting;
    std::vector<Element> moved;
    if (const auto error = changeElements(changed, elements, attempted, false,
                                          [&](Element &element) { moved.push_back(element); }))
        return *error;
    const Result<Drawing *> target = openDrawing(changed, layer, drawing, attempted);
    if (!target)
        return target.error();
    erase(changed, elements);
    (*target)->elements.insert((*target)->elements.end(), moved.begin(), moved.end());
    return changed;
}

Result<AddedElements> duplicateElements(const Painting &painting, const std::vector<ElementId> &elements,
                                        LayerId layer, int drawing)
{
    static const char attempted[] = "Duplicating strokes";
    AddedElements added{painting, {}};
    std::vector<Element> copies;
    if (const auto error = changeElements(added.painting, elements, attempted, true,
                                          [&](Element &element) { copies.push_back(element); }))
        return *error;
    const Result<Drawing *> target = openDrawing(added.painting, layer, drawing, attempted);
    if (!target)
        return target.error();
    for (Element &copy : copies) {
        copy.id = ElementId{added.painting.nextId++};
        added.elements.push_back(copy.id);
        (*target)->elements.push_back(std::move(copy));
    }
    return added;
}

Result<Painting> transformElements(const Painting &painting, const std::vector<ElementId> &elements,
                                   const Placement &change)
{
    static const char attempted[] = "Transforming strokes";
    if (!change.isValid())
        return refusal(attempted, "the transform is not finite or has no scale", "Give a scale above zero");
    Painting changed = painting;
    bool isValid = true; // scales multiply: they can pass all bounds
    if (const auto error = changeElements(changed, elements, attempted, false, [&](Element &element) {
            element.placement = change * element.placement;
            isValid = isValid && element.placement.isValid();
        }))
        return *error;
    if (!isValid)
        return refusal(attempted, "a stroke would become too large or too small", "Scale it less");
    return changed;
}

Result<Painting> replaceShapes(const Painting &painting, const std::vector<ElementId> &elements,
                               const std::vector<std::shared_ptr<const ElementShape>> &shapes)
{
    static const char attempted[] = "Replacing shapes";
    if (elements.empty() || (shapes.size() != 1 && shapes.size() != elements.size()))
        return refusal(attempted, "there is not one shape for all elements nor one for each",
                       "Give one shape, or as many as elements");
    std::unordered_map<ElementId, std::shared_ptr<const ElementShape>> shapeOf;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const std::shared_ptr<const ElementShape> &shape = shapes[shapes.size() == 1 ? 0 : i];
        if (!shape)
            return refusal(attempted, "a shape is missing", "Give every element a shape");
        shapeOf[elements[i]] = shape;
    }
    for (const auto &shape : shapes)
        if (const Result<void> check = checkShape(*shape); !check)
            return unsound(check.error(), attempted);
    Painting changed = painting;
    if (const auto error = changeElements(changed, elements, attempted, false,
                                          [&](Element &element) { element.shape = shapeOf.at(element.id); }))
        return *error;
    return changed;
}

Result<Painting> recolourElements(const Painting &painting, const std::vector<ElementId> &elements,
                                  const Eigen::Vector3f &colour)
{
    static const char attempted[] = "Recolouring strokes";
    if (!(colour.minCoeff() >= 0 && colour.maxCoeff() <= 1 && colour.allFinite()))
        return refusal(attempted, "the colour is not in 0..1", "Choose another colour");
    Painting changed = painting;
    if (const auto error = changeElements(changed, elements, attempted, false, [&](Element &element) {
            element.shape = recoloured(*element.shape, colour);
        }))
        return *error;
    return changed;
}

} // namespace ductus
