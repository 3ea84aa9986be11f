// The line a tube is swept along: even steps, no bend tighter than the tube can follow.
#pragma once

#include "surfacing/parts/tube.h"

namespace ductus {

struct CentreLine
{
    std::vector<Vec3> points;
    std::vector<double> radii;  // one a point
    std::vector<Vec3> tangents; // one a point, unit
    bool isLoop = false;        // the last point is followed by the first, which is not repeated

    int size() const { return int(points.size()); }
};

/// \a points must have length. One line, or several where it turns back on itself sharper than any tube can.
std::vector<CentreLine> centreLines(const std::vector<Vec3> &points, const std::vector<double> &radii,
                                    const TubeOptions &options);

} // namespace ductus
