// The masks of a layer: their product, for every surface point it colours.
#pragma once

#include "render/passes/frame_context.h"

namespace ductus {

/// Blocks of texture masks on the card, kept while a painting names them.
class MaskBlocks
{
public:
    GLuint textureOf(const TextureMask &mask);
    /// Forgets what was not asked for since the last call.
    void dropUnused();

private:
    struct Block
    {
        GlTexture texture;
        std::shared_ptr<const std::vector<std::uint8_t>> values; // kept, so that its address stays its name
        bool isUsed = true;
    };
    std::map<const void *, Block> mBlocks;
};

bool hasMasks(const DrawnLayer &layer);

/// Into the mask's target; the layer's own colour must be complete.
Result<void> drawMasks(FrameContext &frame, MaskBlocks &blocks, const DrawnLayer &layer,
                       const PixelRect &rect, StackId onlyStack);

} // namespace ductus
