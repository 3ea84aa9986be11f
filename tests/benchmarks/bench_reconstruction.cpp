// bench_reconstruction: how well cameras, depth and moving things are found, on clips whose truth is known
// (doodles.md section 2), and what it costs. Exit codes: 0 everything was measured, 1 a measurement failed,
// 2 wrong usage. A missed target is a finding, not a failure.
#include "benchmarks/reconstruction/rgbd_clip.h"
#include "benchmarks/reconstruction/scene_truth.h"
#include "benchmarks/report/resource_meter.h"
#include "benchmarks/report/table.h"
#include "formats/atomic_file.h"
#include "support/clip_scenes.h"

#include <iostream>
#include <span>

using namespace ductus;

namespace {

std::vector<Column> columns()
{
    return {{"clip", "clip", 22},
            {"rung", "rung", 9},
            {"path", "path % of length", 17, 2},
            {"turn", "worst turn deg", 15, 2},
            {"depth", "median depth %", 15, 2},
            {"moving", "moving IoU %", 13, 1},
            {"cpu", "CPU s", 8, 1},
            {"frames", "frames", 7},
            {"peak", "peak MB", 8}};
}

Cell percent(const std::optional<double> &share)
{
    return share ? Cell(100.0 * *share) : Cell();
}

Cell numberOr(const std::optional<double> &number)
{
    return number ? Cell(*number) : Cell();
}

void addRow(Table &table, const std::string &name, const ReconstructionScores &scores, const ResourceUse &use,
            int frames)
{
    table.add({name, scores.rung, percent(scores.pathShare), numberOr(scores.worstTurn),
               percent(scores.medianDepth), percent(scores.movingOverlap), use.cpuSeconds, double(frames),
               numberOr(use.peakMegabytes)});
}

ReconstructionScores scoresOf(const Shot &shot, const ClipScene &scene)
{
    constexpr int stride = 4, everyFrame = 6;
    ReconstructionScores scores;
    scores.rung = rungName(shot.knowledge);
    std::vector<ShotCamera> cameras;
    for (int t = 0; t < scene.frameCount; ++t)
        cameras.push_back(scene.camera(t));
    scores.worstTurn = worstTurnDegrees(shot.cameras, cameras);
    const bool isSolved = shot.knowledge == CameraKnowledge::SolvedCameras;
    if (isSolved)
        scores.pathShare = pathErrorShare(shot.cameras, cameras);
    std::vector<DepthPair> pairs;
    double both = 0.0, either = 0.0;
    for (int t = 0; t < scene.frameCount; t += everyFrame) {
        const ClipTruth truth = renderedFrame(scene, t);
        for (int y = stride / 2; y < scene.height; y += stride)
            for (int x = stride / 2; x < scene.width; x += stride) {
                const std::size_t i = std::size_t(y) * std::size_t(scene.width) + std::size_t(x);
                const Vec2 pixel(x + 0.5, y + 0.5);
                const int body = truth.bodies[i];
                const bool moves = body >= 0 && scene.bodies[std::size_t(body)].worldFromBody != nullptr;
                const bool isFound = shot.objectAt(t, pixel) > 0;
                both += moves && isFound;
                either += moves || isFound;
                if (body >= 0 && !moves)
                    pairs.push_back({shot.depthAt(t, pixel), double(truth.depths[i])});
            }
    }
    if (isSolved) // else it is a guess
        scores.medianDepth = medianDepthError(pairs);
    if (either > 0.0)
        scores.movingOverlap = both / either;
    return scores;
}

void measureScene(Table &table, const ClipScene &scene)
{
    const std::unique_ptr<Clip> clip = clipOf(scene);
    const ResourceMeter meter;
    const Result<Shot> shot = reconstructShot(*clip, {}, {});
    const ResourceUse use = meter.used();
    if (!shot)
        table.addFailure(scene.name, shot.error().message());
    else
        addRow(table, scene.name, scoresOf(*shot, scene), use, scene.frameCount);
}

void measureRoom(Table &table, int frames, int step)
{
    const std::unique_ptr<RgbdClip> clip =
        RgbdClip::open(std::filesystem::path(DUCTUS_SHARED_DATA) / "clips" / "rgbd7scenes", frames, step);
    const std::string name = "7-Scenes, step " + std::to_string(step);
    if (!clip) {
        table.note(name + ": skipped, the frames are not on this machine");
        return;
    }
    const ResourceMeter meter;
    const Result<Shot> shot = reconstructShot(*clip, {}, {});
    const ResourceUse use = meter.used();
    if (!shot) {
        table.addFailure(name, shot.error().message());
        return;
    }
    ReconstructionScores scores;
    scores.rung = rungName(shot->knowledge);
    scores.worstTurn = worstTurnDegrees(shot->cameras, clip->cameras());
    if (shot->knowledge == CameraKnowledge::SolvedCameras)
        scores.pathShare = pathErrorShare(shot->cameras, clip->cameras());
    std::vector<DepthPair> pairs;
    for (int t = 0; t < shot->frameCount(); t += 8)
        for (const DepthPair &pair : clip->depths(*shot, t, 5))
            pairs.push_back(pair);
    scores.medianDepth = medianDepthError(pairs);
    addRow(table, name, scores, use, shot->frameCount());
}

void printUsage(std::ostream &out)
{
    out << "usage: bench_reconstruction [--quick] [--json FILE]\n"
           "  --quick   two small synthetic clips only\n";
}

} // namespace

int main(int argc, char **argv)
{
    bool isQuick = false;
    std::string json;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--quick") {
            isQuick = true;
        } else if (name == "--json" && i + 1 < argc) {
            json = argv[++i];
        } else if (name == "--help") {
            printUsage(std::cout);
            return 0;
        } else {
            std::cerr << "bench_reconstruction: '" << name << "' is unknown, or lacks its value\n";
            printUsage(std::cerr);
            return 2;
        }
    }
    nlohmann::ordered_json report;
    Table synthetic(std::cout,
                    "Synthetic clips, exact truth (rendering the frames is part of the CPU seconds)",
                    columns());
    std::vector<ClipScene> scenes =
        isQuick ? std::vector<ClipScene>{passingScene(240, 134, 12), panScene(240, 134, 12)}
                : allClipScenes(480, 270, 40);
    for (const ClipScene &scene : scenes)
        measureScene(synthetic, scene);
    synthetic.note(
        "Targets: the rung that fits; paths <= 2 % of their length, depth <= 8 % (doodles.md section 2)");
    report["synthetic"] = synthetic.json();
    int failures = synthetic.failures();
    if (!isQuick) {
        Table room(std::cout,
                   "7-Scenes [Shotton et al. 2013]: a room filmed by hand, poses and depth measured",
                   columns());
        measureRoom(room, 80, 1);
        measureRoom(room, 75, 2);
        room.note(
            "Targets: path <= 2 % of its length, depth <= 8 %. COLMAP 3.8 with its defaults finds no model "
            "in clips so short; 80 frames cost it 545 CPU s in matching alone (doodling-research.md 4)");
        report["room"] = room.json();
        failures += room.failures();
    }
    if (!json.empty()) {
        const std::string text = report.dump(2) + "\n";
        if (const Result<void> written =
                writeFileAtomically(json, std::as_bytes(std::span(text)), "Writing the report");
            !written) {
            std::cerr << "bench_reconstruction: " << written.error().message() << "\n";
            return 1;
        }
    }
    return failures > 0 ? 1 : 0;
}
