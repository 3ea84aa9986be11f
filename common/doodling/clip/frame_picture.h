// From a decoded frame to a picture: scaled, in 8-bit RGB, upright. Colours as the film's matrix (BT.601,
// 709, 2020) and range say.
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
    void setColours(const AVFrame &frame);

    AvOwned<SwsContext> mScaler;   // kept while size and format stay
    int mMatrix = -1, mRange = -1; // what the scaler is set to
};

} // namespace ductus
