#include "surfacing/pipeline/finish_surface.h"

#include "geometry/nearest.h"
#include "surfacing/extraction/feature_lines.h"
#include "surfacing/extraction/half_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ductus {

namespace {

Vec3 nearestOnSegment(const Vec3 &p, const Vec3 &a, const Vec3 &b)
{
    const double squaredLength = (b - a).squaredNorm();
    return squaredLength > 0.0 ? Vec3(a + std::clamp((p - a).dot(b - a) / squaredLength, 0.0, 1.0) * (b - a))
                               : a;
}

void measureDeviation(const StrokeSet &unitStrokes, const TriangleMesh &unitMesh, SurfaceResult &result)
{
    const NearestOnMesh nearest(unitMesh);
    std::vector<double> all;
    std::map<int, double> worstOfStroke;
    for (const Stroke &stroke : unitStrokes.strokes) {
        if (stroke.role != StrokeRole::Surface && stroke.role != StrokeRole::Boundary)
            continue;
        for (const Vec3 &p : stroke.points) {
            const double distance = nearest.nearest(p).distance;
            all.push_back(distance);
            double &worst = worstOfStroke[stroke.id.value];
            worst = std::max(worst, distance);
        }
    }
    std::sort(all.begin(), all.end());
    if (!all.empty()) {
        result.deviation.median = all[all.size() / 2];
        result.deviation.p95 = all[std::min(all.size() - 1, all.size() * 95 / 100)];
        result.deviation.max = all.back();
        for (double d : all)
            result.deviation.mean += d / double(all.size());
    }
    for (double &d : result.strokeDeviation)
        d = -1.0;
    for (const auto &[id, worst] : worstOfStroke)
        if (id >= 0 && id < int(result.strokeDeviation.size()))
            result.strokeDeviation[std::size_t(id)] = worst;
}

} // namespace

std::vector<int> wholeRegions(const SeamedMesh &seamed, bool isMirrored, const std::vector<char> &inPlane,
                              int labelCount, std::vector<int> *labelOfRegion)
{
    std::vector<int> regions = seamed.triangleLabels;
    std::vector<int> labels(std::size_t(labelCount), 0);
    for (std::size_t a = 0; a < labels.size(); ++a)
        labels[a] = int(a);
    if (isMirrored) {
        std::vector<char> touches(labels.size());
        for (std::size_t t = 0; t < seamed.mesh.triangles.size(); ++t)
            for (int v : seamed.mesh.triangles[t])
                if (inPlane[std::size_t(v)])
                    touches[std::size_t(seamed.triangleLabels[t])] = 1;
        std::vector<int> image(touches.size());
        for (std::size_t a = 0; a < touches.size(); ++a) {
            image[a] = touches[a] ? int(a) : int(labels.size());
            if (!touches[a])
                labels.push_back(int(a));
        }
        const std::size_t half = regions.size();
        for (std::size_t t = 0; t < half; ++t)
            regions.push_back(image[std::size_t(regions[t])]);
    }
    if (labelOfRegion)
        *labelOfRegion = std::move(labels);
    return regions;
}

std::vector<BorderAttraction> borderTargets(const TriangleMesh &mesh, const StrokeSet &borderStrokes,
                                            const std::vector<char> &inPlane)
{
    const std::vector<char> border = MeshTopology(mesh).borderVertices();
    const double reach = 3.0 * meanEdgeLength(mesh);
    std::vector<BorderAttraction> targets;
    for (std::size_t v = 0; v < border.size(); ++v) {
        if (!border[v] || (!inPlane.empty() && inPlane[v]))
            continue;
        const Vec3 &place = mesh.vertices[v];
        double best = reach;
        BorderAttraction target{int(v), place};
        for (const Stroke &stroke : borderStrokes.strokes)
            for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
                const Vec3 p = nearestOnSegment(place, stroke.points[i], stroke.points[i + 1]);
                if ((p - place).norm() < best) {
                    best = (p - place).norm();
                    target.target = p;
                }
            }
        if (best < reach) // elsewhere the border is free: pinned, it would keep the teeth of the cut
            targets.push_back(target);
    }
    return targets;
}

void finishSurface(const StrokeSet &input, const UnitFrame &frame, const SeamedMesh &seamed,
                   const OptimizedMesh &optimized, const std::optional<SymmetryPlane> &plane,
                   const std::vector<char> &inPlane, const Association &association,
                   const StrokeSet &unitStrokes, SurfaceResult &result)
{
    result.triangleRegions =
        wholeRegions(seamed, plane.has_value(), inPlane, int(result.segmentation.models.size()));
    result.featureLines = featureLines(seamed, optimized.seamSharpness);
    TriangleMesh unitMesh = optimized.mesh;
    if (plane) {
        MirroredMesh whole = withMirrorImage(optimized.mesh, *plane, inPlane);
        const std::size_t half = result.featureLines.size();
        for (std::size_t i = 0; i < half; ++i) {
            std::vector<int> image;
            for (int v : result.featureLines[i])
                image.push_back(whole.imageOfVertex[std::size_t(v)]);
            if (image != result.featureLines[i])
                result.featureLines.push_back(std::move(image));
        }
        unitMesh = std::move(whole.mesh);
        MirroredMesh wholeProxy =
            withMirrorImage(result.proxy.mesh, *plane, verticesInPlane(result.proxy.mesh, *plane));
        result.proxy.mesh = std::move(wholeProxy.mesh);
    }
    result.strokeDeviation.assign(input.strokes.size(), -1.0);
    measureDeviation(unitStrokes, unitMesh, result);
    result.mesh = inInputFrame(unitMesh, frame);
    result.proxy.mesh = inInputFrame(result.proxy.mesh, frame);
    if (result.symmetry) {
        SymmetryPlane &p = result.symmetry->plane;
        p.offset = p.offset * frame.diagonal + p.normal.dot(frame.centre);
        result.symmetry->residual *= frame.diagonal;
    }

    const int regionCount =
        result.triangleRegions.empty()
            ? 0
            : *std::max_element(result.triangleRegions.begin(), result.triangleRegions.end()) + 1;
    result.regions.resize(std::size_t(regionCount));
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t)
        result.regions[std::size_t(result.triangleRegions[t])].area +=
            0.5 * result.mesh.areaVector(int(t)).norm();
    for (std::size_t t = 0; t < seamed.triangleLabels.size(); ++t) {
        const int degree = result.segmentation.models[std::size_t(seamed.triangleLabels[t])].degree;
        result.regions[std::size_t(result.triangleRegions[t])].degree = degree;
        if (plane)
            result.regions[std::size_t(result.triangleRegions[t + seamed.triangleLabels.size()])].degree =
                degree;
    }
    if (!result.proxy.remarks.empty() && result.proxy.kind == ProxyKind::Wrap)
        result.warnings.push_back(
            "The smooth proxy was not usable (" + result.proxy.remarks +
            "); a wrap around the strokes was used. A proxy mesh of your own may give a better "
            "surface.");
    if (!association.unreachedStrokes.empty())
        result.warnings.push_back(std::to_string(association.unreachedStrokes.size()) +
                                  " strokes lie too far from the proxy and were left out.");
}

} // namespace ductus
