#include "benchmarks/tracking/joints_section.h"

#include "benchmarks/report/resource_meter.h"
#include "benchmarks/report/table.h"
#include "doodling/clip/open_clip.h"
#include "doodling/tracking/track_point.h"

#include <cmath>
#include <fstream>
#include <map>

namespace ductus {

namespace {

using Json = nlohmann::json;
using Joint = std::vector<std::pair<int, Vec2>>; // frame, working pixel

// Joints are given as [y, x] in pixels of 1920 x 1080.
std::map<int, Joint> jointsIn(const std::filesystem::path &file, const Shot &shot)
{
    std::map<int, Joint> joints;
    std::ifstream in(file);
    for (const Json &entry : Json::parse(in)) {
        const std::string path = entry["image_path"];
        const int frame = std::stoi(path.substr(path.size() - 9, 5));
        for (std::size_t j = 0; j < entry["joints"].size(); ++j) {
            const double y = entry["joints"][j][0], x = entry["joints"][j][1];
            const Json &visibility = entry["visibility"][j];
            const bool isVisible = visibility.is_boolean() ? visibility.get<bool>() : visibility != 0;
            if (isVisible && (x != 0.0 || y != 0.0) && frame < shot.frameCount())
                joints[int(j)].push_back({frame, {x * shot.width / 1920.0, y * shot.height / 1080.0}});
        }
    }
    std::erase_if(joints, [](const auto &joint) { return joint.second.size() < 3; });
    for (auto &[name, joint] : joints)
        std::sort(joint.begin(), joint.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
    return joints;
}

struct Hits
{
    int within[3] = {0, 0, 0}; // 4, 8, 16 pixels of 256
    int points = 0, seen = 0, tracks = 0;
};

// Keyframes evenly among the annotations, the first and the last among them.
Result<void> track(const Shot &shot, const Joint &joint, int keyframes, Hits &hits)
{
    std::vector<CanvasKeyframe> keys;
    for (int k = 0; k < keyframes; ++k) {
        const std::size_t at =
            keyframes == 1 ? 0
                           : std::size_t(std::lround(double(k) * double(joint.size() - 1) / (keyframes - 1)));
        if (keys.empty() || keys.back().frame != joint[at].first)
            keys.push_back({joint[at].first, joint[at].second, {}, false});
    }
    const Result<std::vector<TrackedPoint>> tracked = trackPoint(shot, keys, {}, {});
    if (!tracked)
        return tracked.error();
    ++hits.tracks;
    for (const auto &[frame, pixel] : joint) {
        const int at = frame;
        if (std::any_of(keys.begin(), keys.end(), [&](const CanvasKeyframe &key) { return key.frame == at; }))
            continue;
        const TrackedPoint &point = (*tracked)[std::size_t(frame)];
        const double off = std::hypot((point.pixel.x() - pixel.x()) * 256.0 / shot.width,
                                      (point.pixel.y() - pixel.y()) * 256.0 / shot.height);
        for (int i = 0; i < 3; ++i)
            hits.within[i] += off < double(4 << i);
        ++hits.points;
        hits.seen += point.isVisible;
    }
    return {};
}

} // namespace

int runJointsSection(const std::filesystem::path &data, nlohmann::ordered_json &report, std::ostream &out)
{
    const std::filesystem::path frames = data / "clips/davis/camel/frames",
                                joints = data / "clips/badja/camel.json";
    if (!std::filesystem::exists(frames) || !std::filesystem::exists(joints)) {
        out << "Joints of filmed animals: left out, there is no " << joints.filename().string()
            << " with its clip\n";
        return 0;
    }
    Table table(out, "Joints of a filmed animal (BADJA on DAVIS camel; % within 4, 8, 16 of 256 pixels)",
                {{"keyframes", "keyframes", 12, 0},
                 {"points", "points", 7, 0},
                 {"delta4", "4", 7, 1},
                 {"delta8", "8", 7, 1},
                 {"delta16", "16", 7, 1},
                 {"delta", "mean", 7, 1},
                 {"seen", "seen", 7, 1},
                 {"milliseconds", "ms/track", 9, 0}});
    Result<std::unique_ptr<Clip>> clip = openClip(frames, {});
    if (!clip) {
        table.addFailure("camel", clip.error().problem);
        return table.failures();
    }
    const ResourceMeter analysis;
    const Result<Shot> shot = reconstructShot(**clip, {}, {});
    const ResourceUse analysed = analysis.used();
    if (!shot) {
        table.addFailure("camel", shot.error().problem);
        return table.failures();
    }
    for (int keyframes : {1, 2, 4}) {
        Hits hits;
        const ResourceMeter meter;
        for (const auto &[name, joint] : jointsIn(joints, *shot))
            if (Result<void> done = track(*shot, joint, keyframes, hits); !done) {
                table.addFailure(std::to_string(keyframes), done.error().problem);
                return table.failures();
            }
        const auto percent = [&](int part) { return 100.0 * part / std::max(1, hits.points); };
        const double mean =
            (percent(hits.within[0]) + percent(hits.within[1]) + percent(hits.within[2])) / 3.0;
        table.add({std::to_string(keyframes), double(hits.points), percent(hits.within[0]),
                   percent(hits.within[1]), percent(hits.within[2]), mean, percent(hits.seen),
                   1000.0 * meter.used().cpuSeconds / std::max(1, hits.tracks)});
    }
    table.note(
        "Analysis of " + std::to_string(shot->frameCount()) + " frames: " +
        std::to_string(int(analysed.cpuSeconds)) + " CPU s, " + std::to_string(int(analysed.wallSeconds)) +
        " s, peak " + std::to_string(int(analysed.peakMegabytes.value_or(0.0))) +
        " MB. Milliseconds are the processor's. Published for the same kind of task: thesis delta_avg "
        "59.2 with one keyframe, 67.3 with two (TAP-Vid-DAVIS, thresholds 1 to 16). Chained DIS flow on "
        "these joints: 68 with one, 73 with two.");
    report["joints"] = table.json();
    return table.failures();
}

} // namespace ductus
