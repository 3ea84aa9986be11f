// The colours of ambiguity maps: where a sketch says too little.
#pragma once

#include "imaging/image.h"

namespace ductus {

/// Of 0 (clear) .. 1 (as open as can be): from grey over orange to a dark violet, also told by lightness.
Rgba ambiguityColour(double value);

} // namespace ductus
