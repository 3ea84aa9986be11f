// Section "sweeps-starts": how much the energy of the segmentation (Eq. III.1) depends on its random start:
// single runs and the best of ten, with the thesis' first models and with weaker ones (Fig. III.10).
#include "benchmarks/report/table.h"
#include "benchmarks/surfacing/contact_sheet.h"
#include "benchmarks/surfacing/swept_solids.h"
#include "strokes/resample.h"
#include "support/sketch_synthesis.h"
#include "surfacing/pipeline/surface_pipeline.h"
#include "surfacing/sketch/unit_frame.h"

#include <algorithm>
#include <optional>

namespace ductus {

namespace {

constexpr int seeds = 10;

const std::vector<Column> columns{
    {"case", "case", 54},       {"samples", "samples", 7},    {"lowest", "lowest", 8, 4},
    {"median", "median", 8, 4}, {"highest", "highest", 8, 4}, {"spreadPercent", "spread %", 8, 1},
};

// Everything before the segmentation, which all runs share.
struct Prepared
{
    StrokeSet strokes;
    TriangleMesh mesh;
    MeshTopology topology;
    Association association;
};

Result<Prepared> prepared(const Solid &solid)
{
    const SurfaceOptions options;
    const StrokeSet drawn = cleaned(synthesizeSketch(solid, {}).strokes);
    StrokeSet strokes = inUnitFrame(drawn, unitFrameOf(drawn));
    for (Stroke &stroke : strokes.strokes)
        stroke = resampled(stroke, options.resamplingStep);
    const Result<Proxy> proxy = makeProxy(strokes, options.proxy, JobControl());
    if (!proxy)
        return proxy.error();
    MeshTopology topology(proxy->mesh);
    Result<Association> association =
        associate(strokes, proxy->mesh, topology, options.association, JobControl());
    if (!association)
        return association.error();
    return Prepared{std::move(strokes), proxy->mesh, std::move(topology), std::move(*association)};
}

void addRow(const std::string &name, std::vector<double> energies, Table &table)
{
    std::sort(energies.begin(), energies.end());
    const double lowest = energies.front(), highest = energies.back();
    table.add({name, double(energies.size()), lowest, energies[energies.size() / 2], highest,
               lowest > 0.0 ? Cell(100.0 * (highest - lowest) / lowest) : Cell()});
}

// The labels two corners of a triangle agree on, else the first.
void addPicture(const std::string &name, const Prepared &task, const Segmentation &segmentation,
                ContactSheet &sheet)
{
    std::vector<int> regions;
    for (const Triangle &t : task.mesh.triangles) {
        const auto label = [&](int corner) {
            return segmentation.labels[std::size_t(t[std::size_t(corner)])];
        };
        regions.push_back(label(1) == label(2) ? label(1) : label(0));
    }
    sheet.add(name, task.mesh, regions, task.strokes);
}

void addSingleRuns(const std::string &name, const Prepared &task, SegmentationOptions options, Table &table,
                   ContactSheet &sheet)
{
    options.runs = seeds;
    const Result<Segmentation> segmentation = segment(task.association, task.topology, options, JobControl());
    if (!segmentation)
        return table.addFailure(name, segmentation.error().message());
    addRow(name, segmentation->runEnergies, table);
    addPicture(name, task, *segmentation, sheet);
}

// What the user gets: the best of the default number of runs, for several seeds.
void addBestOfRuns(const std::string &name, const Prepared &task, SegmentationOptions options, Table &table,
                   ContactSheet &sheet)
{
    std::vector<double> energies;
    std::optional<Segmentation> best;
    for (int seed = 1; seed <= seeds; ++seed) {
        options.seed = std::uint64_t(seed);
        const Result<Segmentation> segmentation =
            segment(task.association, task.topology, options, JobControl());
        if (!segmentation)
            return table.addFailure(name, segmentation.error().message());
        energies.push_back(segmentation->energy);
        if (!best || segmentation->energy < best->energy)
            best = *segmentation;
    }
    addRow(name, energies, table);
    addPicture(name, task, *best, sheet);
}

} // namespace

SectionReport runStartSweeps(const BenchmarkContext &context)
{
    Table table(context.out,
                "SWEEPS: energy of the segmentation over random starts; spread = (highest - lowest) / lowest",
                columns);
    ContactSheet sheet(context, "sweeps-starts");
    for (const Solid &solid : sweptSolids(context)) {
        const Result<Prepared> task = prepared(solid);
        if (!task) {
            table.addFailure(solid.id, task.error().message());
            sheet.addFailure(solid.id);
            continue;
        }
        SegmentationOptions options;
        options.seed = context.seed;
        if (context.runs > 0)
            options.runs = context.runs;
        addSingleRuns(solid.id + ": single runs", *task, options, table, sheet);
        SegmentationOptions unboosted = options;
        unboosted.initialBoost = 1.0;
        addSingleRuns(solid.id + ": single runs, first fits not boosted", *task, unboosted, table, sheet);
        SegmentationOptions oneCount = options;
        oneCount.clusterCounts = {30};
        addSingleRuns(solid.id + ": single runs, 30 clusters only", *task, oneCount, table, sheet);
        addBestOfRuns(solid.id + ": best of " + std::to_string(options.runs), *task, options, table, sheet);
    }
    return {table.json(), table.failures() + sheet.write()};
}

} // namespace ductus
