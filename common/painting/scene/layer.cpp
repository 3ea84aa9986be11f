#include "painting/scene/layer.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>

namespace ductus {

const Drawing &Layer::drawingAt(double timeSeconds) const
{
    const double count = double(frames.drawingOfFrame.size());
    DUCTUS_ASSERT(count > 0);
    double frame = std::floor(std::max(0.0, timeSeconds) * frames.framesPerSecond);
    if (frames.repeatCount > 0 && frame >= count * frames.repeatCount)
        frame = count - 1;
    else
        frame = std::fmod(frame, count);
    return drawings[std::size_t(frames.drawingOfFrame[std::size_t(frame)])];
}

int Layer::elementCount() const
{
    int count = 0;
    for (const Drawing &drawing : drawings)
        count += int(drawing.elements.size());
    return count;
}

} // namespace ductus
