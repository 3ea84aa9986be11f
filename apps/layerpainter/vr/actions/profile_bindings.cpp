#include "layerpainter/vr/actions/profile_bindings.h"

namespace ductus {

namespace {

struct Component
{
    HandAction action;
    const char *left, *right;
};

ControllerProfile profileOf(const char *path, std::initializer_list<Component> components)
{
    ControllerProfile profile{path, {}};
    const auto add = [&](HandAction action, const char *hand, const char *component) {
        profile.bindings.push_back({action, std::string("/user/hand/") + hand + component});
    };
    for (const char *hand : {"left", "right"}) {
        add(HandAction::Grip, hand, "/input/grip/pose");
        add(HandAction::Aim, hand, "/input/aim/pose");
        add(HandAction::Haptic, hand, "/output/haptic");
    }
    for (const Component &component : components) {
        add(component.action, "left", component.left);
        add(component.action, "right", component.right);
    }
    return profile;
}

Component both(HandAction action, const char *path)
{
    return {action, path, path};
}

} // namespace

std::vector<ControllerProfile> controllerProfiles()
{
    return {
        // Two buttons a hand: the second grabs the canvas, everything else is on the panels.
        profileOf("/interaction_profiles/khr/simple_controller",
                  {both(HandAction::Trigger, "/input/select/click"),
                   both(HandAction::Squeeze, "/input/menu/click")}),
        profileOf("/interaction_profiles/oculus/touch_controller",
                  {both(HandAction::Trigger, "/input/trigger/value"),
                   both(HandAction::Squeeze, "/input/squeeze/value"),
                   both(HandAction::Stick, "/input/thumbstick"),
                   {HandAction::Primary, "/input/x/click", "/input/a/click"},
                   {HandAction::Secondary, "/input/y/click", "/input/b/click"}}),
        profileOf("/interaction_profiles/valve/index_controller",
                  {both(HandAction::Trigger, "/input/trigger/value"),
                   both(HandAction::Squeeze, "/input/squeeze/value"),
                   both(HandAction::Stick, "/input/thumbstick"), both(HandAction::Primary, "/input/a/click"),
                   both(HandAction::Secondary, "/input/b/click")}),
        profileOf("/interaction_profiles/microsoft/motion_controller",
                  {both(HandAction::Trigger, "/input/trigger/value"),
                   both(HandAction::Squeeze, "/input/squeeze/click"),
                   both(HandAction::Stick, "/input/thumbstick"),
                   both(HandAction::Primary, "/input/trackpad/click"),
                   both(HandAction::Secondary, "/input/menu/click")}),
    };
}

} // namespace ductus
