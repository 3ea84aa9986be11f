// Section "scribble": seconds from a scribble to new regions and on to the new final mesh, for every kind of
// scribble on samples with a proxy of 12,000 vertices. Targets (surfacing.md section 3): 0.3 s and 1.5 s.
#include "benchmarks/report/resource_meter.h"
#include "benchmarks/report/table.h"
#include "benchmarks/surfacing/benchmark_context.h"
#include "support/sample_sketches.h"
#include "surfacing/pipeline/surfacing_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double labelTarget = 0.3, meshTarget = 1.5; // seconds

const std::vector<Column> columns{
    {"sketch", "sketch", 16},        {"kind", "kind", 11},
    {"proxyVertices", "proxy V", 7}, {"regionsBefore", "regions", 7},
    {"regionsAfter", "after", 5},    {"labelSeconds", "labels s", 8, 3},
    {"labelVerdict", "", 4},         {"meshSeconds", "mesh s", 6, 2},
    {"meshVerdict", "", 4},          {"othersPercent", "others %", 8},
};

std::vector<Vec3> centroidsOf(const LabelPreview &preview, int region)
{
    std::vector<Vec3> centroids;
    for (int t = 0; t < preview.mesh.triangleCount(); ++t)
        if (preview.triangleRegions[std::size_t(t)] == region)
            centroids.push_back(preview.mesh.centroid(t));
    return centroids;
}

Vec3 nearestOf(const std::vector<Vec3> &points, const Vec3 &wanted)
{
    return *std::min_element(points.begin(), points.end(), [&](const Vec3 &a, const Vec3 &b) {
        return (a - wanted).squaredNorm() < (b - wanted).squaredNorm();
    });
}

int longestAxis(const Box3 &box)
{
    int axis = 0;
    (box.max - box.min).maxCoeff(&axis);
    return axis;
}

// Centroids of a region's triangles from end to end along its longest direction, few enough for a hand.
std::vector<Vec3> lineAcross(const LabelPreview &preview, int region)
{
    const std::vector<Vec3> centroids = centroidsOf(preview, region);
    const Box3 box = boundingBox(centroids);
    const int axis = longestAxis(box);
    std::vector<Vec3> line;
    constexpr int count = 12;
    for (int i = 0; i < count; ++i) {
        Vec3 wanted = box.centre();
        wanted[axis] = box.min[axis] + (box.max[axis] - box.min[axis]) * (0.1 + 0.8 * i / (count - 1));
        line.push_back(nearestOf(centroids, wanted));
    }
    return line;
}

// What parts a region: a line across, or a ring around one that is a tube, like the body of a bottle.
std::vector<Vec3> lineParting(const LabelPreview &preview, int region)
{
    const std::vector<Vec3> centroids = centroidsOf(preview, region);
    const Box3 box = boundingBox(centroids);
    const Vec3 half = 0.5 * (box.max - box.min), centre = box.centre();
    const int along = longestAxis(box), u = (along + 1) % 3, v = (along + 2) % 3;
    const bool isTube = (nearestOf(centroids, centre) - centre).norm() > 0.7 * std::min(half[u], half[v]);
    if (!isTube)
        return lineAcross(preview, region);
    std::vector<Vec3> ring;
    constexpr int count = 24;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % count) / count;
        Vec3 wanted = centre;
        wanted[u] += half[u] * std::cos(angle);
        wanted[v] += half[v] * std::sin(angle);
        ring.push_back(nearestOf(centroids, wanted));
    }
    return ring;
}

int largestRegion(const LabelPreview &preview)
{
    const auto byArea = [](const SurfaceRegion &a, const SurfaceRegion &b) { return a.area < b.area; };
    return int(std::max_element(preview.regions.begin(), preview.regions.end(), byArea) -
               preview.regions.begin());
}

// From the middle of the largest region into the largest one next to it.
std::vector<Vec3> lineIntoNeighbour(const LabelPreview &preview)
{
    const int region = largestRegion(preview);
    const MeshTopology topology(preview.mesh);
    int best = -1, face = -1;
    for (const MeshEdge &edge : topology.edges) {
        if (edge.faceCount != 2)
            continue;
        const int a = preview.triangleRegions[std::size_t(edge.faces[0])];
        const int b = preview.triangleRegions[std::size_t(edge.faces[1])];
        const int other = a == region ? b : b == region ? a : -1;
        if (other < 0 || other == region)
            continue;
        if (best < 0 || preview.regions[std::size_t(other)].area > preview.regions[std::size_t(best)].area) {
            best = other;
            face = edge.faces[0];
        }
    }
    const std::vector<Vec3> inside = lineAcross(preview, region);
    if (best < 0)
        return inside;
    return {inside[inside.size() / 2], preview.mesh.centroid(face), lineAcross(preview, best)[6]};
}

std::vector<Scribble> scribblesFor(const LabelPreview &preview)
{
    const std::vector<Vec3> across = lineAcross(preview, largestRegion(preview));
    const std::vector<Vec3> detail(across.begin() + 4, across.begin() + 7);
    const std::vector<Vec3> parting = lineParting(preview, largestRegion(preview));
    return {{ScribbleKind::Merge, lineIntoNeighbour(preview), 0},
            {ScribbleKind::NewRegion, detail, 0},
            {ScribbleKind::Split, parting, 0},
            {ScribbleKind::Seam, parting, 0},
            {ScribbleKind::ForbidSeam, lineIntoNeighbour(preview), 0},
            {ScribbleKind::Lock, detail, 0},
            {ScribbleKind::SetDegree, detail, 3}};
}

void measure(const std::string &name, const SurfacingState &state, const Scribble &scribble, Table &table)
{
    const std::string kind(scribbleKindName(scribble.kind));
    const ResourceMeter labelMeter;
    const Result<SurfacingState> labelled = solveLabels(state, {scribble}, state.options, JobControl());
    const double labelSeconds = labelMeter.used().wallSeconds;
    if (!labelled)
        return table.addFailure(name + " " + kind, labelled.error().message());
    const ResourceMeter meshMeter;
    const Result<SurfacingState> finished = extractSurface(*labelled, state.options, JobControl());
    const ResourceUse use = meshMeter.used();
    if (!finished)
        return table.addFailure(name + " " + kind, finished.error().message());
    table.add({name, kind, double(state.proxy->proxy.mesh.vertexCount()),
               double(state.labels->segmentation.models.size()),
               double(labelled->labels->segmentation.models.size()), labelSeconds,
               std::string(labelSeconds <= labelTarget ? "OK" : "MISS"), use.wallSeconds,
               std::string(labelSeconds + use.wallSeconds <= meshTarget ? "OK" : "MISS"),
               use.othersShare ? Cell(100.0 * *use.othersShare) : Cell()});
}

} // namespace

SectionReport runScribbleSection(const BenchmarkContext &context)
{
    Table table(context.out,
                "SCRIBBLE: wall seconds from a scribble to new regions, and on to the final mesh", columns);
    for (const SampleSketch &sample : sampleSketches()) {
        if (!context.wants(sample.id) || (context.quick && sample.id != sampleSketches().front().id))
            continue;
        SurfaceOptions options;
        options.segmentation.seed = context.seed;
        options.segmentation.runs = 1;
        const StrokeSet strokes = synthesizeSketch(sample.makeSolid(), sample.options).strokes;
        Result<SurfacingState> state = prepareSurfacing(strokes, std::nullopt, options, JobControl());
        if (state)
            state = solveLabels(*state, {}, options, JobControl());
        if (!state) {
            table.addFailure(sample.id, state.error().message());
            continue;
        }
        for (const Scribble &scribble : scribblesFor(*state->preview))
            measure(sample.id, *state, scribble, table);
    }
    table.note("targets: labels 0.3 s; labels and mesh together 1.5 s");
    return {{{"measured", table.json()}}, table.failures()};
}

} // namespace ductus
