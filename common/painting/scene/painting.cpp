#include "painting/scene/painting.h"

namespace ductus {

namespace {

template <typename Visit>
void visitLayers(const Painting &painting, const Visit &visit)
{
    const auto visitStack = [&](const Stack &stack) {
        if (stack.substrate)
            visit(stack, *stack.substrate);
        for (const Layer &layer : stack.appearance)
            visit(stack, layer);
    };
    for (const Stack &stack : painting.stacks)
        visitStack(stack);
    visitStack(painting.sceneStack);
}

} // namespace

const Stack *Painting::findStack(StackId id) const
{
    if (id == sceneStack.id)
        return &sceneStack;
    for (const Stack &stack : stacks)
        if (stack.id == id)
            return &stack;
    return nullptr;
}

const Layer *Painting::findLayer(LayerId id) const
{
    const Layer *found = nullptr;
    visitLayers(*this, [&](const Stack &, const Layer &layer) {
        if (layer.id == id)
            found = &layer;
    });
    return found;
}

const Look *Painting::findLook(LookId id) const
{
    for (const Look &look : looks)
        if (look.id == id)
            return &look;
    return nullptr;
}

const Stack *Painting::stackOf(LayerId id) const
{
    const Stack *found = nullptr;
    visitLayers(*this, [&](const Stack &stack, const Layer &layer) {
        if (layer.id == id)
            found = &stack;
    });
    return found;
}

std::vector<const Layer *> Painting::layers() const
{
    std::vector<const Layer *> all;
    visitLayers(*this, [&](const Stack &, const Layer &layer) { all.push_back(&layer); });
    return all;
}

Stack *Painting::findStack(StackId id)
{
    return const_cast<Stack *>(std::as_const(*this).findStack(id));
}

Layer *Painting::findLayer(LayerId id)
{
    return const_cast<Layer *>(std::as_const(*this).findLayer(id));
}

bool isSubstrate(const Painting &painting, LayerId layer)
{
    const Stack *stack = painting.stackOf(layer);
    return stack && stack->substrate && stack->substrate->id == layer;
}

} // namespace ductus
