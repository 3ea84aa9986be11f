// Overlapping patches of a point set, each small enough for a dense fit: the clusters of the local VIPSS.
//
// A patch is a ball around a point that holds enough points to see a piece of surface. On a cloud those are
// its nearest points. Among strokes the nearest points would be one piece of one stroke, a curve that any
// surface may turn about; there the ball grows until it holds points to both sides, and a well-spread subset
// of them is taken.
#pragma once

#include "geometry/point_tree.h"

namespace ductus {

struct PatchOptions
{
    int points = 48;          // of a patch
    double coverShare = 0.45; // points within this share of a patch's radius start no patch of their own
    double leastWidth = 0.15; // second by first principal spread, below which a ball holds but a curve
    int mostGrowth = 32;      // times as many points are looked at before a patch stays a curve
};

struct Patch
{
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;      // of the ball, > 0
    std::vector<int> members; // indices of points, ascending, within the ball
};

/// Every point lies within coverShare of the radius of some patch.
std::vector<Patch> coverWithPatches(const PointTree &tree, const PatchOptions &options);

} // namespace ductus
