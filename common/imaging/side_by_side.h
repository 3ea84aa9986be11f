// Several pictures in one row.
#pragma once

#include "imaging/image.h"

namespace ductus {

/// The \a images from left to right, aligned at the middle, \a gap pixels of \a background between them.
/// Empty images count as absent; without any the result is empty.
Image sideBySide(const std::vector<Image> &images, int gap = 0, Rgba background = {255, 255, 255, 255});

} // namespace ductus
