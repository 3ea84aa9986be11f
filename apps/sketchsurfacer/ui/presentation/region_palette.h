// RegionPalette: which of the region colours each region has. A region keeps its colour from scribble to
// scribble, as long as no neighbour has taken the same.
#pragma once

#include "geometry/triangle_mesh.h"
#include "imaging/image.h"

#include <map>
#include <vector>

namespace ductus {

class RegionPalette
{
public:
    /// Colours for the regions of \a mesh: \a triangleRegions indexes \a regionIds, names that outlive a
    /// solve. What it chose is remembered for the next call.
    std::vector<Rgba> colours(const TriangleMesh &mesh, const std::vector<int> &triangleRegions,
                              const std::vector<int> &regionIds);

private:
    std::map<int, int> mNumberOfId;
};

} // namespace ductus
