#include "painting/edit/scene_edits.h"

#include "painting/edit/refusal.h"

#include <algorithm>
#include <set>

namespace ductus {

namespace {

// Everything of \a painting but its strokes is checked: these edits touch no stroke.
Result<void> checkScene(const Painting &painting, const char *attempted)
{
    Painting scene;
    scene.background = painting.background;
    scene.loopSeconds = painting.loopSeconds;
    scene.camera = painting.camera;
    scene.nextId = painting.nextId;
    for (const MotionGroup &group : painting.motionGroups) {
        MotionGroup bare = group;
        bare.elements.clear();
        scene.motionGroups.push_back(std::move(bare));
    }
    if (const Result<void> checked = checkPainting(scene); !checked)
        return unsound(checked.error(), attempted);
    return {};
}

Result<Painting> checkedScene(Painting painting, const char *attempted)
{
    if (const Result<void> checked = checkScene(painting, attempted); !checked)
        return checked.error();
    return painting;
}

Error noSuchGroup(const char *attempted)
{
    return refusal(attempted, "there is no such group", "Choose a group of this painting");
}

} // namespace

Result<Painting> setScene(const Painting &painting, const Eigen::Vector3f &background, BlendSpace blendSpace,
                          double loopSeconds)
{
    Painting changed = painting;
    changed.background = background;
    changed.blendSpace = blendSpace;
    changed.loopSeconds = loopSeconds;
    return checkedScene(std::move(changed), "Changing the scene");
}

Result<Painting> setCameraKeys(const Painting &painting, const std::vector<CameraKey> &keys)
{
    Painting changed = painting;
    changed.camera.keys = keys;
    return checkedScene(std::move(changed), "Changing the camera path");
}

Result<AddedGroup> addMotionGroup(const Painting &painting, const std::string &name,
                                  const std::vector<ElementId> &elements,
                                  const std::vector<PlacementKey> &keys)
{
    static const char attempted[] = "Adding a group";
    std::set<ElementId> wanted(elements.begin(), elements.end());
    if (wanted.size() != elements.size())
        return refusal(attempted, "a stroke is named twice", "Name every stroke once");
    for (const Layer *layer : painting.layers())
        for (const Drawing &drawing : layer->drawings)
            for (const Element &element : drawing.elements)
                wanted.erase(element.id);
    if (!wanted.empty())
        return refusal(attempted, "a chosen stroke is not in the painting", "Choose it again");
    AddedGroup added{painting, MotionGroupId{painting.nextId}};
    ++added.painting.nextId;
    added.painting.motionGroups.push_back({added.group, name, elements, keys});
    if (const Result<void> checked = checkScene(added.painting, attempted); !checked)
        return checked.error();
    return added;
}

Result<Painting> setGroupKeys(const Painting &painting, MotionGroupId group,
                              const std::vector<PlacementKey> &keys)
{
    static const char attempted[] = "Changing the motion";
    Painting changed = painting;
    const auto found = std::ranges::find(changed.motionGroups, group, &MotionGroup::id);
    if (found == changed.motionGroups.end())
        return noSuchGroup(attempted);
    found->keys = keys;
    return checkedScene(std::move(changed), attempted);
}

Result<Painting> removeMotionGroup(const Painting &painting, MotionGroupId group)
{
    Painting changed = painting;
    if (std::erase_if(changed.motionGroups, [&](const MotionGroup &each) { return each.id == group; }) == 0)
        return noSuchGroup("Removing the group");
    return changed;
}

} // namespace ductus
