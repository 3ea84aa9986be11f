#include "painting/edit/look_edits.h"

#include "painting/edit/refusal.h"

#include <algorithm>

namespace ductus {

namespace {

Error noSuchLook(const char *attempted)
{
    return refusal(attempted, "there is no such look", "Choose a look of this painting");
}

std::vector<std::pair<LayerId, LayerProperties>> currentProperties(const Painting &painting)
{
    std::vector<std::pair<LayerId, LayerProperties>> properties;
    for (const Layer *layer : painting.layers())
        properties.emplace_back(layer->id, layer->properties);
    return properties;
}

} // namespace

AddedLook addLook(const Painting &painting, const std::string &name)
{
    AddedLook added{painting, LookId{painting.nextId}};
    ++added.painting.nextId;
    added.painting.looks.push_back({added.look, name, currentProperties(painting)});
    return added;
}

Result<Painting> updateLook(const Painting &painting, LookId look)
{
    Painting changed = painting;
    for (Look &candidate : changed.looks) {
        if (candidate.id == look) {
            candidate.layers = currentProperties(painting);
            return changed;
        }
    }
    return noSuchLook("Updating the look");
}

Result<Painting> applyLook(const Painting &painting, LookId look)
{
    static const char attempted[] = "Applying the look";
    const Look *found = painting.findLook(look);
    if (!found)
        return noSuchLook(attempted);
    Painting changed = painting;
    for (const auto &[id, properties] : found->layers)
        if (Layer *layer = changed.findLayer(id))
            layer->properties = properties;
    return changed;
}

Result<Painting> renameLook(const Painting &painting, LookId look, const std::string &name)
{
    Painting changed = painting;
    for (Look &candidate : changed.looks) {
        if (candidate.id == look) {
            candidate.name = name;
            return changed;
        }
    }
    return noSuchLook("Renaming the look");
}

Result<Painting> removeLook(const Painting &painting, LookId look)
{
    Painting changed = painting;
    if (std::erase_if(changed.looks, [&](const Look &candidate) { return candidate.id == look; }) == 0)
        return noSuchLook("Removing the look");
    return changed;
}

} // namespace ductus
