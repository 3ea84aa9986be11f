// Props made ready to be drawn, kept from frame to frame: sorting a painting's strokes takes longer than
// drawing it.
#pragma once

#include "doodling/prop/prop.h"
#include "painting/reference/painting_solid.h"

#include <list>
#include <mutex>

namespace ductus {

class PropSolids
{
public:
    /// \a prop in its look as it is in video frame \a frame; null if it cannot be drawn. Safe to be called by
    /// several threads.
    std::shared_ptr<const PaintingSolid> of(const Prop &prop, int frame) const;

private:
    struct Kept
    {
        std::shared_ptr<const PaintingContent> painting; // an address is not used again while it is kept
        std::string look;
        double timeSeconds;
        std::shared_ptr<const PaintingSolid> solid;
    };

    mutable std::mutex mMutex;
    mutable std::list<Kept> mKept; // the last used first
};

} // namespace ductus
