#include "doodling/prop/prop_solids.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr std::size_t mostKept = 16;

} // namespace

std::shared_ptr<const PaintingSolid> PropSolids::of(const Prop &prop, int frame) const
{
    const Painting &painting = prop.painting->painting();
    const bool moves = prop.framesPerSecond > 0.0 && hasMotion(painting);
    const double seconds = moves ? loopedTime(frame / prop.framesPerSecond, painting.loopSeconds) : 0.0;
    const auto isWanted = [&](const Kept &kept) {
        return kept.painting == prop.painting && kept.look == prop.look && kept.timeSeconds == seconds;
    };
    {
        const std::lock_guard lock(mMutex);
        if (const auto kept = std::ranges::find_if(mKept, isWanted); kept != mKept.end()) {
            mKept.splice(mKept.begin(), mKept, kept);
            return mKept.front().solid;
        }
    }
    // Not under the lock: it works in parallel, and a thread that waits there may take up another frame,
    // which comes here as well. Two that make the same are no harm.
    Result<PaintingSolid> solid =
        PaintingSolid::make(painting, {seconds, lookNamed(painting, prop.look)}, {});
    const std::lock_guard lock(mMutex);
    mKept.push_front({prop.painting, prop.look, seconds,
                      solid ? std::make_shared<const PaintingSolid>(std::move(*solid)) : nullptr});
    if (mKept.size() > mostKept)
        mKept.pop_back();
    return mKept.front().solid;
}

} // namespace ductus
