// What a 3D printer, or whoever runs it, wants to know of a mesh before it is printed.
#pragma once

#include "geometry/inspection/self_intersection.h"
#include "geometry/inspection/wall_thickness.h"

#include <optional>

namespace ductus {

struct PrintCheck
{
    Box3 box;
    double area = 0.0;
    double volume = 0.0; // of closed meshes; what overlaps counts twice
    bool isWatertight = false;
    int shells = 0;
    int borderEdges = 0;
    std::optional<Vec3> border; // the middle of an edge where the surface ends

    Thickness thickness; // of watertight meshes
    /// The thinnest wall, narrowest gap: all but the leastShare of the surface is as thick (wide) at least,
    /// so that no single spot of noise counts.
    std::optional<ThicknessSample> thinnestWall, narrowestGap;

    std::vector<TrianglePair> crossings;   // of a shell with itself, at most mostCrossings
    std::vector<TrianglePair> overlaps;    // of two shells, which a slicer makes one; likewise
    std::optional<Vec3> crossing, overlap; // a place of them

    static constexpr double leastShare = 0.0005;
    static constexpr int mostCrossings = 2000;
};

/// Lengths in the unit of \a mesh. A surface with a border has no walls; a mesh that is no manifold is told
/// as not watertight. Error: only Cancelled.
Result<PrintCheck> checkForPrint(const TriangleMesh &mesh, const JobControl &control);

} // namespace ductus
