// The style sheet on top of Fusion: what a palette cannot say. Kept small; controls that need more paint
// themselves.
#pragma once

#include "widgets/theme/palette.h"

#include <QString>

namespace ductus {

QString styleSheet(const ThemeColours &colours);

} // namespace ductus
