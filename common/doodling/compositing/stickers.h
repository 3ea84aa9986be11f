// Ready-made drawings for teachers: drawn by us, in the colour that was chosen.
#pragma once

#include "doodling/compositing/mark_pieces.h"

#include <span>
#include <string_view>

namespace ductus {

/// "star", "heart", "check", ...: what StickerMark::name may be.
std::span<const std::string_view> stickerNames();

/// In a square of side 1 around 0, 0. A name that is not known gives a question mark's bubble.
std::vector<MarkPiece> stickerPieces(std::string_view name, const Rgba &colour);

} // namespace ductus
