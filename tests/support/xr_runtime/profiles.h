// Interaction profiles of OpenXR 1.0 (section 6.4) and which components they have.
#pragma once

#include <string>
#include <string_view>

namespace ductus::xr {

bool isKnownProfile(std::string_view profile);

/// Whether \a path ("/user/hand/left/input/x/click", or the parent of components) is one of \a profile.
bool hasPath(std::string_view profile, std::string_view path);

} // namespace ductus::xr
