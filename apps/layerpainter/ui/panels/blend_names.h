// Blend modes in the user's words.
#pragma once

#include "painting/blend/blend_mode.h"

#include <QString>

namespace ductus {

QString blendText(BlendMode mode);

} // namespace ductus
