// Skeletal strokes: a stroke that stands for a thin cylinder, a cable or a stem, becomes a tube beside the
// surface (thesis Sec. III.9, Fig. III.18, where such strokes had to be deleted by hand).
#pragma once

#include "strokes/stroke.h"
#include "surfacing/parts/tube.h"
#include "surfacing/sketch/symmetry_plane.h"

#include <optional>
#include <string>

namespace ductus {

struct SkeletalOptions
{
    double radius = 0.005; // of a tube, share of the box diagonal; where there is pressure, at half of it
    double leastPressure = 0.1; // lighter counts as this: a tube does not end in a needle
    TubeOptions tube;
};

/// Tubes as closed shells of one mesh. They may reach into the surface and into each other: what is put into
/// a slicer or a modeller is united there.
struct SkeletalTubes
{
    TriangleMesh mesh;                 // in the unit of the strokes
    std::vector<int> triangleTubes;    // index into tubes, one a triangle
    std::vector<StrokeId> tubes;       // the stroke of each; one with a mirror image stands twice
    std::vector<std::string> warnings; // about strokes that give none
};

/// Of the strokes with role Skeletal. \a diagonal and \a plane in the unit of \a strokes. With a plane,
/// strokes on its kept side are mirrored and those on the other side left out, as those of the surface are;
/// one that crosses the plane is taken as drawn.
SkeletalTubes skeletalTubes(const StrokeSet &strokes, double diagonal,
                            const std::optional<SymmetryPlane> &plane, const SkeletalOptions &options);

} // namespace ductus
