// Which buttons of the usual controllers do what. All actions are there for each hand, so that left and right
// can change places while painting; what they mean is decided in hands/.
#pragma once

#include <string>
#include <vector>

namespace ductus {

enum class HandAction { Grip, Aim, Trigger, Squeeze, Stick, Primary, Secondary, Haptic };

struct SuggestedBinding
{
    HandAction action;
    std::string path; // "/user/hand/left/input/trigger/value"
};

struct ControllerProfile
{
    std::string path; // "/interaction_profiles/oculus/touch_controller"
    std::vector<SuggestedBinding> bindings;
};

/// Simple, Touch, Index and Windows Mixed Reality controllers.
std::vector<ControllerProfile> controllerProfiles();

} // namespace ductus
