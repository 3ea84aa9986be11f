#include "support/xr_runtime/profiles.h"

#include <algorithm>
#include <vector>

namespace ductus::xr {

namespace {

struct Profile
{
    std::string_view name;
    std::vector<std::string_view> both, left, right;
};

const std::vector<Profile> &profiles()
{
    static const std::vector<Profile> all{
        {"/interaction_profiles/khr/simple_controller",
         {"/input/select/click", "/input/menu/click", "/input/grip/pose", "/input/aim/pose",
          "/output/haptic"},
         {},
         {}},
        {"/interaction_profiles/oculus/touch_controller",
         {"/input/squeeze/value", "/input/trigger/value", "/input/trigger/touch", "/input/thumbstick/x",
          "/input/thumbstick/y", "/input/thumbstick/click", "/input/thumbstick/touch",
          "/input/thumbrest/touch", "/input/grip/pose", "/input/aim/pose", "/output/haptic"},
         {"/input/x/click", "/input/x/touch", "/input/y/click", "/input/y/touch", "/input/menu/click"},
         {"/input/a/click", "/input/a/touch", "/input/b/click", "/input/b/touch", "/input/system/click"}},
        {"/interaction_profiles/valve/index_controller",
         {"/input/system/click",   "/input/system/touch",     "/input/a/click",
          "/input/a/touch",        "/input/b/click",          "/input/b/touch",
          "/input/squeeze/value",  "/input/squeeze/force",    "/input/trigger/click",
          "/input/trigger/value",  "/input/trigger/touch",    "/input/thumbstick/x",
          "/input/thumbstick/y",   "/input/thumbstick/click", "/input/thumbstick/touch",
          "/input/trackpad/x",     "/input/trackpad/y",       "/input/trackpad/force",
          "/input/trackpad/touch", "/input/grip/pose",        "/input/aim/pose",
          "/output/haptic"},
         {},
         {}},
        {"/interaction_profiles/microsoft/motion_controller",
         {"/input/menu/click", "/input/squeeze/click", "/input/trigger/value", "/input/thumbstick/x",
          "/input/thumbstick/y", "/input/thumbstick/click", "/input/trackpad/x", "/input/trackpad/y",
          "/input/trackpad/click", "/input/trackpad/touch", "/input/grip/pose", "/input/aim/pose",
          "/output/haptic"},
         {},
         {}},
    };
    return all;
}

const Profile *find(std::string_view name)
{
    const auto found = std::ranges::find(profiles(), name, &Profile::name);
    return found == profiles().end() ? nullptr : &*found;
}

} // namespace

bool isKnownProfile(std::string_view profile)
{
    return find(profile) != nullptr;
}

bool hasPath(std::string_view name, std::string_view path)
{
    const Profile *profile = find(name);
    if (!profile)
        return false;
    for (const std::string_view hand : {"/user/hand/left", "/user/hand/right"}) {
        if (!path.starts_with(hand))
            continue;
        const std::string_view component = path.substr(hand.size());
        const auto isIt = [&](std::string_view known) {
            return known == component ||
                   (known.starts_with(component) && known[component.size()] == '/' && component.size() > 6);
        };
        return std::ranges::any_of(profile->both, isIt) ||
               std::ranges::any_of(hand.ends_with("left") ? profile->left : profile->right, isIt);
    }
    return false;
}

} // namespace ductus::xr
