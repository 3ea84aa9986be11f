#include "geometry/editable_mesh.h"

#include "base/assert.h"
#include "geometry/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

EditableMesh::EditableMesh(const TriangleMesh &mesh, double creaseAngleDegrees)
    : mPosition(mesh.vertices), mOutgoing(mesh.vertices.size(), -1), mFeatureDegree(mesh.vertices.size(), 0),
      mOpposite(3 * mesh.triangles.size(), -1), mCrease(3 * mesh.triangles.size(), 0)
{
    mCorner.reserve(3 * mesh.triangles.size());
    for (const Triangle &t : mesh.triangles)
        for (int v : t) {
            mOutgoing[v] = int(mCorner.size());
            mCorner.push_back(v);
        }
    const MeshTopology topology(mesh);
    const double creaseCosine = std::cos(creaseAngleDegrees * std::numbers::pi / 180.0);
    for (int e = 0; e < int(topology.edges.size()); ++e) {
        const MeshEdge &edge = topology.edges[e];
        DUCTUS_ASSERT(edge.faceCount <= 2);
        int sides[2] = {-1, -1};
        for (int i = 0; i < edge.faceCount; ++i)
            for (int k = 0; k < 3; ++k)
                if (topology.faceEdges[edge.faces[i]][k] == e)
                    sides[i] = 3 * edge.faces[i] + k;
        bool feature = edge.faceCount == 1;
        if (edge.faceCount == 2) {
            DUCTUS_ASSERT(from(sides[0]) == to(sides[1]));
            join(sides[0], sides[1]);
            feature = creaseAngleDegrees > 0.0 &&
                      mesh.faceNormal(edge.faces[0]).dot(mesh.faceNormal(edge.faces[1])) < creaseCosine;
            mCrease[sides[0]] = mCrease[sides[1]] = feature ? 1 : 0;
        }
        mFeatureDegree[edge.v0] += feature ? 1 : 0;
        mFeatureDegree[edge.v1] += feature ? 1 : 0;
    }
}

Vec3 EditableMesh::areaVector(int h) const
{
    const Vec3 &a = mPosition[from(h)];
    return (mPosition[to(h)] - a).cross(mPosition[apex(h)] - a);
}

bool EditableMesh::isBorderVertex(int v) const
{
    int h = mOutgoing[v];
    do {
        h = mOpposite[previous(h)];
    } while (h >= 0 && h != mOutgoing[v]);
    return h < 0;
}

void EditableMesh::outgoing(int v, std::vector<int> &halfEdges) const
{
    halfEdges.clear();
    int h = mOutgoing[v];
    // A fan starts at its clockwise end.
    for (int g = mOpposite[h]; g >= 0; g = mOpposite[h]) {
        h = next(g);
        if (h == mOutgoing[v])
            break;
    }
    const int first = h;
    do {
        halfEdges.push_back(h);
        h = mOpposite[previous(h)];
    } while (h >= 0 && h != first);
}

void EditableMesh::neighbours(int v, std::vector<int> &vertices) const
{
    outgoing(v, vertices);
    const int last = previous(vertices.back());
    for (int &h : vertices)
        h = to(h);
    if (mOpposite[last] < 0)
        vertices.push_back(from(last));
}

int EditableMesh::addTriangle(int a, int b, int c)
{
    const int h = int(mCorner.size());
    mCorner.insert(mCorner.end(), {a, b, c});
    mOpposite.insert(mOpposite.end(), 3, -1);
    mCrease.insert(mCrease.end(), 3, 0);
    return h;
}

void EditableMesh::join(int h, int g)
{
    if (h >= 0)
        mOpposite[h] = g;
    if (g >= 0)
        mOpposite[g] = h;
}

void EditableMesh::setCrease(int h, bool crease)
{
    mCrease[h] = crease ? 1 : 0;
    if (mOpposite[h] >= 0)
        mCrease[mOpposite[h]] = crease ? 1 : 0;
}

int EditableMesh::split(int h)
{
    const int g = mOpposite[h];
    const int a = from(h);
    const int b = to(h);
    const bool feature = isFeature(h);
    const bool crease = mCrease[h];
    const int m = vertexCount();
    mPosition.push_back(0.5 * (mPosition[a] + mPosition[b]));
    mOutgoing.push_back(-1);
    mFeatureDegree.push_back(feature ? 2 : 0);

    // a b c becomes a m c and m b c.
    const int c = apex(h);
    const int hb = addTriangle(m, b, c);
    const int bc = next(h);
    const int outsideBc = mOpposite[bc];
    const bool creaseBc = mCrease[bc];
    mCorner[bc] = m;
    join(next(hb), outsideBc);
    setCrease(next(hb), creaseBc);
    join(bc, previous(hb));
    setCrease(bc, false);
    mOutgoing[m] = hb;
    mOutgoing[b] = next(hb);

    if (g >= 0) { // b a d becomes b m d and m a d
        const int d = apex(g);
        const int ga = addTriangle(m, a, d);
        const int ad = next(g);
        const int outsideAd = mOpposite[ad];
        const bool creaseAd = mCrease[ad];
        mCorner[ad] = m;
        join(next(ga), outsideAd);
        setCrease(next(ga), creaseAd);
        join(ad, previous(ga));
        setCrease(ad, false);
        join(h, ga);
        join(hb, g);
        setCrease(ga, crease);
        setCrease(g, crease);
        mOutgoing[a] = h;
    }
    return m;
}

bool EditableMesh::canCollapse(int h)
{
    const int removed = from(h);
    const int kept = to(h);
    const int g = mOpposite[h];
    if (mFeatureDegree[removed] != 0 && (mFeatureDegree[removed] != 2 || !isFeature(h)))
        return false;
    const bool borderRemoved = isBorderVertex(removed);
    if (borderRemoved && g >= 0)
        return false;

    // Of the two edges that fall together on either side at most one may be a feature, and not both are
    // borders.
    for (int side : {h, g})
        if (side >= 0 && isFeature(next(side)) && isFeature(previous(side)))
            return false;

    // Link condition [Dey, Edelsbrunner, Guha, Nekhayev 1999]: no common neighbours but the apexes.
    neighbours(removed, mRingA);
    neighbours(kept, mRingB);
    std::sort(mRingB.begin(), mRingB.end());
    const auto common = std::count_if(mRingA.begin(), mRingA.end(), [&](int v) {
        return std::binary_search(mRingB.begin(), mRingB.end(), v);
    });
    if (common != (g >= 0 ? 2 : 1))
        return false;
    const int merged = int(mRingA.size() + mRingB.size()) - (g >= 0 ? 4 : 3);
    if (merged < (borderRemoved || isBorderVertex(kept) ? 2 : 3))
        return false;
    for (int side : {h, g}) {
        if (side < 0)
            continue;
        const int c = apex(side);
        neighbours(c, mRingB);
        if (int(mRingB.size()) <= (isBorderVertex(c) ? 2 : 3))
            return false;
    }
    return true;
}

void EditableMesh::collapse(int h)
{
    const int removed = from(h);
    const int kept = to(h);
    const int g = mOpposite[h];
    outgoing(removed, mRingA);
    for (int out : mRingA)
        mCorner[out] = kept;
    for (int side : {h, g}) {
        if (side < 0)
            continue;
        const int c = apex(side);
        const int left = mOpposite[next(side)];
        const int right = mOpposite[previous(side)];
        const bool crease = mCrease[next(side)] || mCrease[previous(side)];
        // The corners of the vanished triangle need another half-edge that leaves them.
        if (left >= 0) { // runs c -> kept
            mOutgoing[c] = left;
            mOutgoing[kept] = next(left);
        } else { // right runs kept -> c
            mOutgoing[kept] = right;
            mOutgoing[c] = next(right);
        }
        join(left, right);
        const int merged = left >= 0 ? left : right;
        setCrease(merged, crease && left >= 0 && right >= 0);
    }
    for (int side : {h, g}) {
        if (side < 0)
            continue;
        const int t = side - side % 3;
        for (int k = 0; k < 3; ++k) {
            mCorner[t + k] = -1;
            mOpposite[t + k] = -1;
            mCrease[t + k] = 0;
        }
    }
    mOutgoing[removed] = -1;
}

bool EditableMesh::canFlip(int h)
{
    const int g = mOpposite[h];
    if (isFeature(h))
        return false;
    neighbours(apex(h), mRingA);
    if (std::find(mRingA.begin(), mRingA.end(), apex(g)) != mRingA.end())
        return false;
    for (int v : {from(h), to(h)}) {
        neighbours(v, mRingA);
        if (int(mRingA.size()) <= (isBorderVertex(v) ? 2 : 3))
            return false;
    }
    return true;
}

void EditableMesh::flip(int h)
{
    // a b c | b a d becomes a d c | b c d, in place: h then runs d -> c, g runs c -> d.
    const int g = mOpposite[h];
    const int a = from(h);
    const int b = to(h);
    const int c = apex(h);
    const int d = apex(g);
    const int hn = next(h);     // b c
    const int hp = previous(h); // c a
    const int gn = next(g);     // a d
    const int gp = previous(g); // d b
    const int outBc = mOpposite[hn];
    const int outAd = mOpposite[gn];
    const bool creaseBc = mCrease[hn];
    const bool creaseAd = mCrease[gn];
    // Triangle of h: (d, c, a) with h = d->c, hn = c->a, hp = a->d; triangle of g: (c, d, b).
    const int outCa = mOpposite[hp];
    const bool creaseCa = mCrease[hp];
    const int outDb = mOpposite[gp];
    const bool creaseDb = mCrease[gp];
    mCorner[h] = d;
    mCorner[hn] = c;
    mCorner[hp] = a;
    mCorner[g] = c;
    mCorner[gn] = d;
    mCorner[gp] = b;
    join(h, g);
    join(hn, outCa);
    setCrease(hn, creaseCa);
    join(hp, outAd);
    setCrease(hp, creaseAd);
    join(gn, outDb);
    setCrease(gn, creaseDb);
    join(gp, outBc);
    setCrease(gp, creaseBc);
    mOutgoing[a] = hp;
    mOutgoing[b] = gp;
    mOutgoing[c] = hn;
    mOutgoing[d] = gn;
}

TriangleMesh EditableMesh::toTriangleMesh() const
{
    TriangleMesh mesh;
    mesh.vertices = mPosition;
    for (int h = 0; h < halfEdgeCount(); h += 3)
        if (mCorner[h] >= 0)
            mesh.triangles.push_back({mCorner[h], mCorner[h + 1], mCorner[h + 2]});
    return compacted(mesh);
}

} // namespace ductus
