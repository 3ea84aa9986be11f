// Paintings to and from their JSON and arrays. Small things are JSON, numbers of points are columns: a
// painting of 57,000 strokes has a JSON of some kilobytes.
#pragma once

#include "painting/storage/painting_content.h"

namespace ductus {

inline constexpr std::size_t maxPaintingText = 4096; // bytes of a name
inline constexpr std::size_t maxPaintingParts = 1'000'000;
inline constexpr int maxPictureSide = 32768; // pixels

/// The JSON of a checked painting; its arrays are added to \a packer, which this finishes.
OrderedJson paintingToJson(const Painting &painting, const UnknownPaintingMembers &unknown, const Uuid &id,
                           BufferPacker &packer);

/// The same for a painting within a document of another kind: its arrays are slots (array_slots.h) until \a
/// packer is finished and resolveArrays() was called.
OrderedJson paintingWithSlots(const Painting &painting, const UnknownPaintingMembers &unknown, const Uuid &id,
                              BufferPacker &packer);

/// Reads version paintingVersion; what is wrong is told through \a reader (ask failed() afterwards). The
/// result keeps the invariants of painting_check.h then.
Painting paintingFromJson(const JsonReader &reader, ArrayLoader &arrays, UnknownPaintingMembers &unknown);

} // namespace ductus
