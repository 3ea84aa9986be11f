// How far strokes lie from the surface, as colours: a map even to the eye, from blue (on it) over green to
// yellow.
#pragma once

#include "base/job_control.h"
#include "imaging/image.h"
#include "strokes/stroke.h"

namespace ductus {

/// Colour of \a share 0..1 of the largest deviation; even in lightness and never red against green.
Rgba deviationColour(double share);

struct DeviationMap
{
    double largest = 0.0; // scene units, a round number of metres: the map's upper end
    std::vector<std::vector<double>> strokeDistance; // scene units, one a point of each stroke
    std::vector<Rgba> vertexColours;                 // of the surface: grey away from strokes
    std::vector<double> regionDeviation; // mean over the stroke points nearest to each region; -1: none
};

/// \a strokes whose role is Surface or Boundary count; others have empty distances.
DeviationMap deviationMap(const TriangleMesh &surface, const std::vector<int> &triangleRegions,
                          int regionCount, const StrokeSet &strokes, const JobControl &control);

} // namespace ductus
