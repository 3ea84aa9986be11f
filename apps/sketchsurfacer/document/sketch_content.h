// SketchContent: everything a user of SketchSurfacer decides about one sketch, as one value. Large parts are
// shared and immutable, so an undo history keeps whole contents: undo restores exactly, whatever the edit
// was.
#pragma once

#include "surfacing/pipeline/restart.h"

#include <cstdint>
#include <memory>

namespace ductus {

struct StoredReading; // project/sketch_surface_document.h

/// What the user took a sketch for where it leaves more than one surface open
/// (surfacing/pipeline/ambiguity.h).
struct ChosenReading
{
    std::shared_ptr<const SurfacingState> labelled; // to be extracted; null: of a file, see stored
    std::shared_ptr<const StrokeSet> strokes;       // it is a reading of
    std::shared_ptr<const StoredReading> stored;    // as the file has it; null: chosen in this session
};

struct SketchContent
{
    std::shared_ptr<const StrokeSet> strokes = std::make_shared<const StrokeSet>();
    std::shared_ptr<const TriangleMesh> givenProxy; // null: made automatically
    SurfaceOptions options;
    std::vector<Scribble> scribbles;
    std::shared_ptr<const ChosenReading> reading; // null: the likeliest
    /// Names this content in the process: equal numbers mean equal content. Given by SketchDocument.
    std::uint64_t id = 0;
    /// Results of contents with a smaller id are nothing to continue from: the user asked for a fresh start.
    std::uint64_t startsAnewFrom = 0;
};

/// What the solver gets.
SurfacingRequest requestOf(const SketchContent &content);

/// Whether a state made of \a before may be continued for \a after: same strokes, same given proxy, same
/// reading of them.
bool hasSameInput(const SketchContent &before, const SketchContent &after);

/// The options the window begins with: automatic symmetry.
SurfaceOptions defaultSurfaceOptions();

} // namespace ductus
