// A manifold triangle mesh whose edges can be split, collapsed and flipped: what the remesher works on.
// Half-edge h = 3 t + k runs from corner k to corner k+1 of triangle t. Every operation keeps the mesh an
// oriented manifold or is refused by its canX() question.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vector>

namespace ductus {

class EditableMesh
{
public:
    /// \a mesh must be an oriented manifold. Edges that turn by more than \a creaseAngleDegrees become
    /// features as the borders are; 0 makes none.
    EditableMesh(const TriangleMesh &mesh, double creaseAngleDegrees);

    int vertexCount() const { return int(mPosition.size()); }
    int halfEdgeCount() const { return int(mOpposite.size()); }
    bool vertexIsAlive(int v) const { return mOutgoing[v] >= 0; }
    bool halfEdgeIsAlive(int h) const { return mCorner[h] >= 0; }

    static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
    int from(int h) const { return mCorner[h]; }
    int to(int h) const { return mCorner[next(h)]; }
    int apex(int h) const { return mCorner[previous(h)]; }
    int opposite(int h) const { return mOpposite[h]; }

    const Vec3 &position(int v) const { return mPosition[v]; }
    void move(int v, const Vec3 &position) { mPosition[v] = position; }
    double squaredLength(int h) const { return (mPosition[from(h)] - mPosition[to(h)]).squaredNorm(); }
    Vec3 areaVector(int h) const;

    /// On the border or on a crease.
    bool isFeature(int h) const { return mOpposite[h] < 0 || mCrease[h]; }
    /// Number of feature edges that end at \a v: 0 for smooth vertices, 2 along a curve, else a corner.
    int featureDegree(int v) const { return mFeatureDegree[v]; }
    bool isBorderVertex(int v) const;

    /// Half-edges that leave \a v, counter-clockwise.
    void outgoing(int v, std::vector<int> &halfEdges) const;
    /// Vertices joined to \a v by an edge, counter-clockwise.
    void neighbours(int v, std::vector<int> &vertices) const;

    /// Puts a vertex into the middle of edge \a h.
    int split(int h);

    /// Would removing from(h) by pulling it into to(h) keep the mesh a manifold, features in place and
    /// corners?
    bool canCollapse(int h);
    void collapse(int h);

    /// Would joining the apexes on both sides of \a h instead of its ends keep the mesh a manifold?
    bool canFlip(int h);
    void flip(int h);

    TriangleMesh toTriangleMesh() const;

private:
    int addTriangle(int a, int b, int c);
    void join(int h, int g);
    void setCrease(int h, bool crease);

    std::vector<Vec3> mPosition;
    std::vector<int> mOutgoing;      // one half-edge that leaves the vertex, -1 for removed vertices
    std::vector<int> mFeatureDegree; // see featureDegree()
    std::vector<int> mCorner;        // start of each half-edge, -1 for removed triangles
    std::vector<int> mOpposite;      // -1 on the border
    std::vector<char> mCrease;
    std::vector<int> mRingA; // work arrays
    std::vector<int> mRingB;
};

} // namespace ductus
