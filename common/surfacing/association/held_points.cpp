#include "surfacing/association/held_points.h"

namespace ductus {

void holdFlatEnds(Association &association, const std::vector<FlatEnd> &ends, const TriangleMesh &proxy,
                  const NearestOnMesh &nearest)
{
    for (const FlatEnd &end : ends)
        for (const Vec3 &p : end.inside) {
            const NearestPoint foot = nearest.nearest(p);
            if (foot.distance > end.spacing)
                continue; // the other half of a symmetric sketch, or the proxy has gone its own way
            int corner = 0;
            foot.barycentric.maxCoeff(&corner);
            const int v = proxy.triangles[std::size_t(foot.triangle)][std::size_t(corner)];
            if (!association.pointsOfVertex[std::size_t(v)].empty())
                continue;
            association.pointsOfVertex[std::size_t(v)].push_back(int(association.points.size()));
            association.points.push_back({p, end.outwards});
        }
}

} // namespace ductus
