// Tubes along polylines: generalised cylinders with a round section, for strokes that stand for a cable or a
// stem (thesis Sec. III.9, skeletal strokes; generalised cylinders as in its reference [348]).
#pragma once

#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

enum class TubeEnds { Round, Flat };

struct TubeOptions
{
    TubeEnds ends = TubeEnds::Round;
    int sides = 12;             // of the section; at least 3
    double stepInRadii = 0.75;  // between sections; shorter ones make no smoother tube
    double tightestBend = 1.15; // radii; the centre line is rounded until it bends no tighter ...
    double farthestShift = 1.5; // ... where this many radii suffice; elsewhere the tube gets thinner
    double loopLength = 4.0;    // circumferences; a shorter line with touching ends is no ring
    int mostSections = 20'000;  // of one tube
};

/// One closed, outwards oriented tube (a torus where the ends of \a points touch) of \a radii, one a point,
/// all in the unit of \a points. Frames turn as little as can be [Wang et al. 2008, Computation of rotation
/// minimizing frames]. Sections never reach into each other: in a bend tighter than the tube is thick the
/// tube is thinner. A line that runs back on itself gives several closed pieces. TooLittleData where \a
/// points have no length, InvalidArgument where a radius is not positive or a number is not finite.
Result<TriangleMesh> sweptTube(const std::vector<Vec3> &points, const std::vector<double> &radii,
                               const TubeOptions &options = {});

} // namespace ductus
