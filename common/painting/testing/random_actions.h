// Any action at all on a painting, for tests; some are refused, as a painter's would be.
#pragma once

#include "painting/action/action.h"
#include "painting/testing/sample_painting.h"

namespace ductus {

inline PaintingAction randomAction(const Painting &painting, Random &random)
{
    const auto layers = painting.layers();
    const auto pick = [&](const auto &items) -> const auto &
    {
        return items[std::size_t(random.index(int(items.size())))];
    };
    const LayerId layer = layers.empty() ? LayerId{0} : pick(layers)->id;
    const StackId stack =
        painting.stacks.empty() || random.index(3) == 0 ? sceneStackId : pick(painting.stacks).id;
    const LookId look = painting.looks.empty() ? LookId{0} : pick(painting.looks).id;
    const MotionGroupId group =
        painting.motionGroups.empty() ? MotionGroupId{0} : pick(painting.motionGroups).id;
    std::vector<ElementId> some;
    ElementId stroke{0};
    std::size_t points = 2;
    for (const Layer *each : layers)
        for (const Element &element : each->drawings[0].elements) {
            if (random.index(6) == 0)
                some.push_back(element.id);
            if (const auto *shape = std::get_if<StrokeShape>(element.shape.get());
                shape && random.index(4) == 0) {
                stroke = element.id;
                points = shape->points.size();
            }
        }
    const Eigen::Vector3f colour(float(random.uniform()), float(random.uniform()), float(random.uniform()));
    const std::vector<PlacementKey> keys{{0, {}, KeyInterpolation::Linear},
                                         {1, samplePlacement(random), KeyInterpolation::Smooth}};
    const int position = random.index(4) - 1;
    const std::string name = "name " + std::to_string(random.index(100));
    switch (random.index(int(std::variant_size_v<PaintingAction>))) {
    case 0:
        return act::AddStack{name, position};
    case 1:
        return random.index(3) == 0 ? PaintingAction(act::RemoveStack{stack}) : act::AddStack{name, position};
    case 2:
        return act::MoveStack{stack, position};
    case 3:
        return act::RenameStack{stack, name};
    case 4:
        return act::AddLayer{stack, name, position};
    case 5:
        return act::RemoveLayer{layer};
    case 6:
        return act::MoveLayer{layer, stack, position};
    case 7:
        return act::DuplicateLayer{layer, name};
    case 8:
        return act::RenameLayer{layer, name};
    case 9:
        return act::LockLayer{layer, random.index(4) == 0};
    case 10: {
        act::SetProperties edit;
        edit.layer = layer;
        if (random.index(2))
            edit.opacity = random.uniform();
        if (random.index(2))
            edit.visible = random.index(2) == 0;
        if (random.index(3) == 0)
            edit.blend = BlendMode(random.index(blendModeCount));
        if (random.index(3) == 0)
            edit.colour = colour;
        if (random.index(4) == 0)
            edit.ownColours = true;
        if (random.index(3) == 0)
            edit.masks = samplePainting(3).stacks[0].appearance[0].properties.masks;
        return edit;
    }
    case 11:
        return act::SetTolerance{layer, random.uniform(), ToleranceMode(random.index(2))};
    case 12:
        return act::SetLayerMotion{layer, keys};
    case 13:
        return act::Draw{layer,
                         0,
                         random.index(2) ? samplePlacement(random) : Placement(),
                         {sampleStroke(random, 3, StrokeSection(random.index(4)))}};
    case 14:
        if (random.index(3) == 0)
            return act::ReplaceShape{some, {sampleStroke(random, 4, StrokeSection(random.index(4)))}};
        return random.index(2) == 0 ? PaintingAction(act::Erase{some}) : act::Recolour{some, colour};
    case 15: {
        const double from = random.uniform(0, double(points - 1) / 2);
        return act::Cut{stroke, {{from, from + 0.25 * double(points - 1)}}};
    }
    case 16:
        return act::MoveElements{some, layer, 0};
    case 17:
        return act::Duplicate{some, layer, 0, random.index(2) ? samplePlacement(random) : Placement()};
    case 18: {
        Placement change = samplePlacement(random);
        change.scale = 1; // scales multiply
        return act::Transform{some, change};
    }
    case 19:
        return act::Recolour{some, colour};
    case 20:
        return act::AddLook{name};
    case 21:
        return act::UpdateLook{look};
    case 22:
        return act::ApplyLook{look};
    case 23:
        return act::RenameLook{look, name};
    case 24:
        return act::RemoveLook{look};
    case 25: {
        act::SetScene edit;
        edit.background = colour;
        if (random.index(2))
            edit.blendSpace = BlendSpace(random.index(2));
        if (random.index(2))
            edit.loopSeconds = random.uniform(0, 10);
        return edit;
    }
    case 26: {
        CameraKey key;
        key.eye = {random.normal(), 1, 5};
        key.rotation = samplePlacement(random).rotation;
        return act::SetCamera{{key}};
    }
    case 27:
        return act::AddGroup{some, name, keys};
    case 28:
        return act::SetGroupMotion{group, keys};
    default:
        return act::RemoveGroup{group};
    }
}

} // namespace ductus
