// The OpenGL context that is current, as the headset's software wants it.
#pragma once

#include "base/result.h"

#include <openxr/openxr.h>

namespace ductus {

class HeadsetRuntime;

/// Makes a session in the current context; GLX contexts only, as XR_KHR_opengl_enable has none for EGL on
/// X11. The context is current afterwards, whatever the software did.
Result<XrSession> createGlxSession(const HeadsetRuntime &runtime);

} // namespace ductus
