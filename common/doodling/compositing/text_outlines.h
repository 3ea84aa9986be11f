// The outlines of words: FreeType draws them from the fonts of this computer (Noto Sans where there is one).
// Letters stand side by side with their kerning; scripts whose letters join or change their order (Arabic,
// Devanagari) are not shaped.
#pragma once

#include "doodling/scene/shot_camera.h"

#include <memory>
#include <string_view>
#include <vector>

namespace ductus {

class TextOutlines
{
public:
    TextOutlines();
    ~TextOutlines();
    TextOutlines(const TextOutlines &) = delete;
    TextOutlines &operator=(const TextOutlines &) = delete;

    /// Closed outlines for winding numbers, lines of height 1 below each other, all centred on 0, 0; y down.
    /// A character no font has comes as an empty box. Safe to be called by several threads.
    std::vector<std::vector<Vec2>> of(std::string_view text, bool isBold) const;

private:
    struct Fonts;
    std::unique_ptr<Fonts> mFonts;
};

} // namespace ductus
