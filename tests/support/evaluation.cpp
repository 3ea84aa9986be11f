#include "support/evaluation.h"

#include "base/parallel.h"
#include "base/random.h"
#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "strokes/resample.h"
#include "support/segment_index.h"
#include "support/solid_builder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ductus {

namespace {

const char *const attempted = "Comparing the surface with the truth";

Result<void> checked(const TriangleMesh &mesh, const std::string &name)
{
    for (const Vec3 &vertex : mesh.vertices)
        if (!vertex.allFinite())
            return Error{ErrorCode::InvalidArgument, attempted, "a vertex of the " + name + " is not finite",
                         "", ""};
    for (const Triangle &triangle : mesh.triangles)
        for (const int v : triangle)
            if (v < 0 || v >= mesh.vertexCount())
                return Error{ErrorCode::InvalidArgument, attempted,
                             "a triangle of the " + name + " names a vertex that does not exist", "", ""};
    if (!(surfaceArea(mesh) > 0.0))
        return Error{ErrorCode::TooLittleData, attempted, "the " + name + " has no area", "", ""};
    return {};
}

std::vector<double> distancesTo(const NearestOnMesh &nearest, const std::vector<Vec3> &points)
{
    std::vector<double> distances(points.size());
    parallelFor(
        0, points.size(), [&](std::size_t i) { distances[i] = nearest.nearest(points[i]).distance; }, 256);
    return distances;
}

std::vector<Vec3> pointsOf(const std::vector<SurfacePoint> &samples)
{
    std::vector<Vec3> points;
    for (const SurfacePoint &sample : samples)
        points.push_back(sample.point);
    return points;
}

/// Share of the length of \a segments whose parts (cut at \a step) have their middle within \a tolerance of
/// \a index.
double shareNear(const std::vector<Segment> &segments, const SegmentIndex &index, double step,
                 double tolerance)
{
    double all = 0.0, near = 0.0;
    for (const Segment &segment : segments) {
        const double length = (segment.b - segment.a).norm();
        const int parts = std::max(1, int(std::ceil(length / step)));
        for (int k = 0; k < parts; ++k) {
            const Vec3 middle = segment.a + (segment.b - segment.a) * ((k + 0.5) / parts);
            all += length / parts;
            if (index.isWithin(middle, tolerance))
                near += length / parts;
        }
    }
    return all > 0.0 ? near / all : 1.0;
}

std::vector<Segment> segmentsOf(const std::vector<std::vector<Vec3>> &polylines)
{
    std::vector<Segment> segments;
    for (const std::vector<Vec3> &line : polylines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            segments.push_back({line[i], line[i + 1]});
    return segments;
}

std::vector<Segment> creaseEdges(const TriangleMesh &mesh, double angleDegrees)
{
    const MeshTopology topology(mesh);
    std::vector<Segment> edges;
    for (std::size_t e = 0; e < topology.edges.size(); ++e)
        if (dihedralDegrees(mesh, topology, int(e)) > angleDegrees)
            edges.push_back({mesh.vertices[topology.edges[e].v0], mesh.vertices[topology.edges[e].v1]});
    return edges;
}

} // namespace

DeviationStatistics deviationStatistics(std::vector<double> distances, double diagonal)
{
    if (distances.empty())
        return {};
    std::sort(distances.begin(), distances.end());
    const double percent = 100.0 / diagonal;
    const auto quantile = [&](double share) {
        return distances[std::size_t(std::lround(share * double(distances.size() - 1)))] * percent;
    };
    const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
    return {quantile(0.5), sum / double(distances.size()) * percent, quantile(0.95),
            distances.back() * percent};
}

std::vector<SurfacePoint> sampledByArea(const TriangleMesh &mesh, int count, std::uint64_t seed)
{
    std::vector<double> upTo;
    double area = 0.0;
    for (int t = 0; t < mesh.triangleCount(); ++t)
        upTo.push_back(area += 0.5 * mesh.areaVector(t).norm());
    std::vector<SurfacePoint> samples;
    if (!(area > 0.0))
        return samples;
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const double target = area * (i + random.uniform()) / count;
        const auto it = std::upper_bound(upTo.begin(), upTo.end(), target);
        const int t = int(std::min(it, upTo.end() - 1) - upTo.begin());
        const Triangle &corners = mesh.triangles[t];
        // Square root: uniform in the triangle.
        const double r = std::sqrt(random.uniform()), s = random.uniform();
        samples.push_back({(1.0 - r) * mesh.vertices[corners[0]] + r * (1.0 - s) * mesh.vertices[corners[1]] +
                               r * s * mesh.vertices[corners[2]],
                           t});
    }
    return samples;
}

Result<SurfaceDeviation> surfaceDeviation(const TriangleMesh &result, const TriangleMesh &truth,
                                          const EvaluationOptions &options)
{
    if (const auto ok = checked(result, "result"); !ok)
        return ok.error();
    if (const auto ok = checked(truth, "truth"); !ok)
        return ok.error();
    const double diagonal = boundingBox(truth.vertices).diagonal();
    const NearestOnMesh onResult(result), onTruth(truth);
    const auto fromResult = pointsOf(sampledByArea(result, options.samples, options.seed));
    const auto fromTruth = pointsOf(sampledByArea(truth, options.samples, options.seed));
    return SurfaceDeviation{deviationStatistics(distancesTo(onTruth, fromResult), diagonal),
                            deviationStatistics(distancesTo(onResult, fromTruth), diagonal)};
}

Result<DeviationStatistics> strokeDeviation(const StrokeSet &strokes, const TriangleMesh &mesh)
{
    if (const auto ok = checked(mesh, "surface"); !ok)
        return ok.error();
    const double diagonal = boundingBox(mesh.vertices).diagonal();
    std::vector<Vec3> points;
    for (const Stroke &stroke : strokes.strokes) {
        if (stroke.points.empty() ||
            (stroke.role != StrokeRole::Surface && stroke.role != StrokeRole::Boundary))
            continue;
        const std::vector<Vec3> even = resampled(stroke.points, 0.002 * diagonal);
        points.insert(points.end(), even.begin(), even.end());
    }
    if (points.empty())
        return Error{ErrorCode::TooLittleData, attempted, "there are no strokes to compare with", "", ""};
    return deviationStatistics(distancesTo(NearestOnMesh(mesh), points), diagonal);
}

Result<CreaseScore> creaseScore(const TriangleMesh &result, const GroundTruth &truth,
                                const EvaluationOptions &options)
{
    if (const auto ok = checked(result, "result"); !ok)
        return ok.error();
    const double diagonal = boundingBox(truth.mesh.vertices).diagonal();
    if (!(diagonal > 0.0))
        return Error{ErrorCode::TooLittleData, attempted, "the truth has no extent", "", ""};
    const double tolerance = options.creaseTolerance * diagonal, step = 0.0025 * diagonal;
    const std::vector<Segment> edges = creaseEdges(result, options.creaseAngleDegrees);
    const std::vector<Segment> trueEdges = creaseEdges(truth.mesh, options.creaseAngleDegrees);
    CreaseScore score;
    for (const Segment &edge : edges)
        score.resultLength += (edge.b - edge.a).norm();
    score.recall = shareNear(segmentsOf(truth.drawnCreases), SegmentIndex(edges, tolerance), step, tolerance);
    score.precision = shareNear(edges, SegmentIndex(trueEdges, tolerance), step, tolerance);
    return score;
}

int regionCount(const TriangleMesh &mesh, const std::vector<int> &triangleLabels)
{
    const MeshTopology topology(mesh);
    std::vector<char> done(triangleLabels.size(), 0);
    int count = 0;
    for (std::size_t seed = 0; seed < triangleLabels.size(); ++seed) {
        if (done[seed])
            continue;
        ++count;
        std::vector<int> stack{int(seed)};
        done[seed] = 1;
        while (!stack.empty()) {
            const int face = stack.back();
            stack.pop_back();
            for (const int edge : topology.faceEdges[face]) {
                const int other = topology.across(edge, face);
                if (other < 0 || done[other] || triangleLabels[other] != triangleLabels[seed])
                    continue;
                done[other] = 1;
                stack.push_back(other);
            }
        }
    }
    return count;
}

Result<double> regionCountRatio(const TriangleMesh &result, const std::vector<int> &triangleLabels,
                                const GroundTruth &truth)
{
    if (int(triangleLabels.size()) != result.triangleCount() || truth.faceCount < 1)
        return Error{ErrorCode::InvalidArgument, attempted, "labels and triangles differ in number", "", ""};
    return double(regionCount(result, triangleLabels)) / truth.faceCount;
}

} // namespace ductus
