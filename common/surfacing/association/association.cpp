#include "surfacing/association/association.h"

#include "geometry/dual_path.h"
#include "geometry/nearest.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

// c^e of Sec. III.6: the distance between the vertices opposite the edge, relative to its mean over the mesh, so
// that an even mesh keeps the plain weights.
std::vector<double> edgeScales(const TriangleMesh &mesh, const MeshTopology &topology)
{
    std::vector<double> scales(topology.edges.size(), 0.0);
    double sum = 0.0;
    int count = 0;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const MeshEdge &edge = topology.edges[e];
        if (edge.faceCount != 2)
            continue;
        Vec3 opposite[2];
        for (int side = 0; side < 2; ++side)
            for (int v : mesh.triangles[std::size_t(edge.faces[side])])
                if (v != edge.v0 && v != edge.v1)
                    opposite[side] = mesh.vertices[std::size_t(v)];
        scales[e] = (opposite[0] - opposite[1]).norm();
        sum += scales[e];
        ++count;
    }
    const double mean = count ? sum / count : 1.0;
    for (double &s : scales)
        s = s > 0.0 && mean > 0.0 ? s / mean : 1.0;
    return scales;
}

Vec3 interpolatedNormal(const TriangleMesh &mesh, const std::vector<Vec3> &normals, const NearestPoint &at)
{
    const Triangle &t = mesh.triangles[std::size_t(at.triangle)];
    const Vec3 n = at.barycentric[0] * normals[std::size_t(t[0])] + at.barycentric[1] * normals[std::size_t(t[1])] +
                   at.barycentric[2] * normals[std::size_t(t[2])];
    const double length = n.norm();
    return length > 1e-9 ? Vec3(n / length) : mesh.faceNormal(at.triangle);
}

// At most one point an edge: the closest one to the vertex (Sec. III.5.1).
std::vector<std::vector<int>> pointsOfVertices(const Association &a, const TriangleMesh &mesh,
                                               const MeshTopology &topology)
{
    std::vector<std::vector<int>> pointsOfEdge(topology.edges.size());
    for (std::size_t i = 0; i < a.samples.size(); ++i)
        pointsOfEdge[std::size_t(a.samples[i].edge)].push_back(int(i));
    std::vector<std::vector<int>> result(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        for (int e : topology.vertexEdges[v]) {
            int best = -1;
            double bestDistance = 0.0;
            for (int i : pointsOfEdge[std::size_t(e)]) {
                const double distance = (a.points[std::size_t(i)].point - mesh.vertices[v]).squaredNorm();
                if (best < 0 || distance < bestDistance) {
                    best = i;
                    bestDistance = distance;
                }
            }
            if (best >= 0)
                result[v].push_back(best);
        }
    return result;
}

// A single point, of a cloud, crosses nothing; it speaks for the nearest edge of its triangle.
void addLonePoint(const Vec3 &point, const NearestPoint &foot, int stroke, const TriangleMesh &mesh,
                  const MeshTopology &topology, const std::vector<Vec3> &normals, Association &a)
{
    int opposite = 0; // corner whose edge across is nearest
    foot.barycentric.minCoeff(&opposite);
    const int edge = topology.faceEdges[std::size_t(foot.triangle)][std::size_t((opposite + 1) % 3)];
    a.points.push_back({point, interpolatedNormal(mesh, normals, foot)});
    a.samples.push_back({stroke, edge});
}

} // namespace

Result<Association> associate(const StrokeSet &strokes, const TriangleMesh &proxy, const MeshTopology &topology,
                              const AssociationOptions &options, const JobControl &control)
{
    Association a;
    const NearestOnMesh nearest(proxy);
    const std::vector<Vec3> normals = vertexNormals(proxy);
    for (std::size_t v = 0; v < normals.size(); ++v)
        a.vertices.push_back({proxy.vertices[v], normals[v]});
    DualPaths paths(proxy, topology);
    a.edgeIsCrossed.assign(topology.edges.size(), 0);

    for (std::size_t s = 0; s < strokes.strokes.size(); ++s) {
        if (control.isCancelled())
            return cancelledError("Associating strokes with the proxy");
        control.progress(double(s) / double(strokes.strokes.size()), "Associating strokes");
        const Stroke &stroke = strokes.strokes[s];
        if (stroke.role != StrokeRole::Surface && stroke.role != StrokeRole::Boundary)
            continue;
        std::vector<NearestPoint> feet(stroke.points.size());
        for (std::size_t i = 0; i < feet.size(); ++i)
            feet[i] = nearest.nearest(stroke.points[i]);
        bool reached = false;
        if (feet.size() == 1 && feet[0].distance <= options.maxDistance) {
            addLonePoint(stroke.points[0], feet[0], int(s), proxy, topology, normals, a);
            reached = true;
        }
        for (std::size_t i = 1; i < feet.size(); ++i) {
            if (feet[i - 1].distance > options.maxDistance || feet[i].distance > options.maxDistance)
                continue;
            reached = true;
            // A segment whose ends project to opposite sides of the proxy has no path worth following.
            const double length = (stroke.points[i] - stroke.points[i - 1]).norm();
            const double reach = 4.0 * (length + feet[i - 1].distance + feet[i].distance) +
                                 8.0 * std::sqrt(proxy.areaVector(feet[i].triangle).norm());
            const std::vector<int> crossed = paths.crossedEdges(feet[i - 1].triangle, feet[i].triangle, reach);
            const int n = int(crossed.size());
            for (int k = 0; k < n; ++k) {
                const double t = (k + 0.5) / n; // n regularly spaced points on the segment
                OrientedPoint p;
                p.point = (1.0 - t) * stroke.points[i - 1] + t * stroke.points[i];
                const MeshEdge &edge = topology.edges[std::size_t(crossed[std::size_t(k)])];
                p.normal = (normals[std::size_t(edge.v0)] + normals[std::size_t(edge.v1)]).normalized();
                if (!p.normal.allFinite() || p.normal.norm() < 0.5)
                    p.normal = interpolatedNormal(proxy, normals, feet[i]);
                a.points.push_back(p);
                a.samples.push_back({int(s), crossed[std::size_t(k)]});
                a.edgeIsCrossed[std::size_t(crossed[std::size_t(k)])] = 1;
            }
        }
        if (!reached)
            a.unreachedStrokes.push_back(int(s));
    }
    if (a.points.empty())
        return Error{ErrorCode::TooLittleData, "Associating strokes with the proxy",
                     "no stroke lies near the proxy mesh",
                     "Check that proxy and sketch have the same position, axes and scale", ""};

    a.pointsOfVertex = pointsOfVertices(a, proxy, topology);
    for (const std::vector<int> &points : a.pointsOfVertex)
        a.pairCount += int(points.size());
    a.edgeWeights = edgeScales(proxy, topology);
    for (std::size_t e = 0; e < a.edgeWeights.size(); ++e)
        a.edgeWeights[e] *= a.edgeIsCrossed[e] ? options.crossedEdgeWeight : options.uncrossedEdgeWeight;
    return a;
}

} // namespace ductus
