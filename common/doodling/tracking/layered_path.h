// The rough trajectory (thesis VI.5.2, Eq. VI.1): through each frame's cells, so that steps in scene space
// agree with the scene flow. Edges join consecutive frames only, so the shortest path is found layer by
// layer; the thesis runs Dijkstra on the whole graph.
//
// Beyond the thesis: hidden stretches. A path may leave the cells and go on as it moved last, at a price a
// frame, and come back where it meets a cell again: what the thesis leaves out as skip edges (VI.6.3), which
// would multiply the edges. Here each frame carries only the cheapest few hidden points.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <vector>

namespace ductus {

/// A cell of a frame.
struct PathCell
{
    Vec3 place = Vec3::Zero();
    Vec3 motion = Vec3::Zero(); // scene flow to the next frame
    double cost = 0.0;          // of being there: what makes a cell unsafe, squared scene units
    bool isKeyframed = false;   // its flow is not looked at: nearness decides (published program)
};

struct LayeredPathOptions
{
    double hiddenCost = 0.0025; // a frame in hiding, squared scene units
    int hiddenPoints = 48;      // kept a frame; 0: the path never leaves the cells
    int longestHidden = 24;     // frames
};

struct LayeredPath
{
    std::vector<int> cells;   // one a frame, -1 where hidden
    std::vector<Vec3> places; // one a frame
    double cost = 0.0;
};

/// One layer of cells a frame, none empty; frames with a keyframe have a single cell. InvalidArgument
/// otherwise.
Result<LayeredPath> shortestPath(const std::vector<std::vector<PathCell>> &layers,
                                 const LayeredPathOptions &options, const JobControl &control);

} // namespace ductus
