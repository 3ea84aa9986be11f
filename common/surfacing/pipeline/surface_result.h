// What the whole chain gives: the surface, its regions and creases, and how well it follows the strokes.
#pragma once

#include "strokes/stroke.h"
#include "surfacing/proxy/proxy.h"
#include "surfacing/segmentation/segmentation.h"
#include "surfacing/sketch/symmetry_plane.h"

#include <optional>
#include <string>

namespace ductus {

/// Wall seconds, phases as in Table III.1.
struct SurfaceTimings
{
    double proxy = 0.0;
    double association = 0.0;  // part of phase 1
    double segmentation = 0.0; // the rest of phase 1 and phase 2
    double extraction = 0.0;   // phase 3
    double total = 0.0;
};

struct StrokeDeviationStatistics // stroke samples to the surface, share of the sketch's box diagonal
{
    double median = 0.0, mean = 0.0, p95 = 0.0, max = 0.0;
};

struct SurfaceRegion
{
    int degree = 0;                 // of its surface model; 0 for a tube
    double area = 0.0;              // input units squared
    std::optional<StrokeId> tubeOf; // the skeletal stroke it is a tube around
};

struct SurfaceResult
{
    TriangleMesh mesh; // input coordinates, manifold, consistently oriented; tubes are shells beside it
    std::vector<int> triangleRegions;           // index into regions, one a triangle
    std::vector<SurfaceRegion> regions;         // one a surface model and side of the symmetry plane
    std::vector<std::vector<int>> featureLines; // creases: polylines of vertex indices
    std::vector<double> strokeDeviation; // largest of each stroke, share of the diagonal; -1 if not used
    StrokeDeviationStatistics deviation;
    std::optional<SymmetryProposal> symmetry; // the plane used, input coordinates
    Proxy proxy;                              // input coordinates
    Segmentation segmentation;                // on the (half) proxy, unit frame
    SurfaceTimings timings;
    std::vector<std::string> warnings;
};

} // namespace ductus
