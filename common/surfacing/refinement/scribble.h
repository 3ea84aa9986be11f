// Scribbles: what a designer draws over a result to say where it should be otherwise (thesis Sec. III.6, User
// control, Fig. III.9: new region, merge; the other kinds are beyond the thesis). Plain data, made by the
// window and read from files alike.
#pragma once

#include "geometry/triangle_mesh.h"

#include <optional>
#include <string_view>
#include <vector>

namespace ductus {

enum class ScribbleKind {
    NewRegion,  // what lies under it gets a region of its own (thesis: yellow)
    Merge,      // the regions it touches become one (thesis: green)
    Seam,       // a border runs exactly here (red)
    ForbidSeam, // no border runs here
    Split,      // the region falls in two along it; if it closes up, into inside and outside
    Lock,       // the regions it touches stay as they are, whatever is scribbled later
    SetDegree,  // the regions it touches get surfaces of the given degree
};

struct Scribble
{
    ScribbleKind kind = ScribbleKind::NewRegion;
    std::vector<Vec3> points; // input coordinates, on or near the preview or the surface; one point is enough
                              // to touch a region, lines (Seam, Split) need two
    int degree = 0; // 1 plane, 2 quadric, 3 cubic, 4 quartic. SetDegree needs it; for NewRegion, Merge and
                    // Split 0 leaves the choice to the solver

    bool operator==(const Scribble &) const = default;
};

/// Stable names for files: "new-region", "merge", "seam", "forbid-seam", "split", "lock", "set-degree".
std::string_view scribbleKindName(ScribbleKind kind);
std::optional<ScribbleKind> scribbleKindFromName(std::string_view name);

} // namespace ductus
