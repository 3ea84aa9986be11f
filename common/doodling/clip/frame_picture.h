// From a decoded frame to a picture: scaled, in 8-bit RGB, upright.
#pragma once

#include "base/result.h"
#include "formats/film/av_handles.h"
#include "imaging/image.h"

namespace ductus {

class FramePicture
{
public:
    /// \a mostLines of the upright picture, 0: as it is. \a rotationDegrees clockwise.
    Result<Image> make(const AVFrame &frame, int rotationDegrees, int mostLines);

private:
    AvOwned<SwsContext> mScaler; // kept while size and format stay
};

} // namespace ductus
