// A scribble laid on the proxy: the vertices nearest to it and the edges it crosses, found by walking the
// dual graph from point to point (surfacing.md section 1).
#pragma once

#include "surfacing/refinement/refinement.h"

namespace ductus {

struct ScribblePath
{
    std::vector<int> vertices;     // nearest to the line, each once, in the order of walking
    std::vector<int> crossedEdges; // in the order of walking; an edge crossed twice stands here twice
    std::vector<int> left,
        right; // beside crossedEdges: the end of the edge on either side, looking along the line
    std::vector<int> triangles; // walked through, first to last
};

/// Points beyond the plane of a symmetric sketch are mirrored to the solved half. Fails with InvalidArgument
/// if there is no point, or none near the proxy.
Result<ScribblePath> layOnProxy(const ScribbleDomain &domain, const std::vector<Vec3> &points);

/// The ends of \a edge left and right of somebody who crosses it out of triangle \a from.
std::pair<int, int> sidesOfCrossing(const TriangleMesh &mesh, const MeshTopology &topology, int edge,
                                    int from);

} // namespace ductus
