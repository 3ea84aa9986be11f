#include "benchmarks/tracking/photo_section.h"

#include "benchmarks/report/resource_meter.h"
#include "benchmarks/report/table.h"
#include "benchmarks/tracking/photo_clips.h"
#include "doodling/tracking/track_point.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double spacing = 55.0; // pixels of the cut-out between points
constexpr int fewestSeen = 3;    // frames

struct Hits
{
    int within[3] = {0, 0, 0}; // 4, 8, 16 pixels of 256
    int seen = 0, told = 0, rightlyTold = 0, tracks = 0;
};

// Keyframes evenly among the frames in which the point is seen, the first and the last among them.
std::vector<CanvasKeyframe> keyframesOf(const PhotoTrack &track, int count)
{
    std::vector<int> seen;
    for (std::size_t t = 0; t < track.pixels.size(); ++t)
        if (track.isVisible[t])
            seen.push_back(int(t));
    std::vector<CanvasKeyframe> keys;
    if (int(seen.size()) < std::max(fewestSeen, count))
        return keys;
    for (int k = 0; k < count; ++k) {
        const int frame = seen[count == 1 ? 0 : std::size_t(k) * (seen.size() - 1) / std::size_t(count - 1)];
        keys.push_back({frame, track.pixels[std::size_t(frame)], {}, false});
    }
    return keys;
}

Result<void> add(const Shot &shot, const PhotoTrack &truth, int keyframes, Hits &hits)
{
    const std::vector<CanvasKeyframe> keys = keyframesOf(truth, keyframes);
    if (keys.empty())
        return {};
    const Result<std::vector<TrackedPoint>> tracked = trackPoint(shot, keys, {}, {});
    if (!tracked)
        return tracked.error();
    ++hits.tracks;
    for (int t = keys.front().frame + 1; t < shot.frameCount(); ++t) {
        if (std::any_of(keys.begin(), keys.end(), [&](const CanvasKeyframe &key) { return key.frame == t; }))
            continue;
        const TrackedPoint &point = (*tracked)[std::size_t(t)];
        const bool isVisible = truth.isVisible[std::size_t(t)];
        ++hits.told;
        hits.rightlyTold += point.isVisible == isVisible;
        if (!isVisible)
            continue;
        const Vec2 off = point.pixel - truth.pixels[std::size_t(t)];
        const double distance = Vec2(off.x() * 256.0 / shot.width, off.y() * 256.0 / shot.height).norm();
        for (int i = 0; i < 3; ++i)
            hits.within[i] += distance < double(4 << i);
        ++hits.seen;
    }
    return {};
}

Result<void> addRows(const PhotoScene &scene, Table &table)
{
    const std::unique_ptr<Clip> clip = clipOf(scene);
    const Result<Shot> shot = reconstructShot(*clip, {}, {});
    if (!shot)
        return shot.error();
    const std::vector<PhotoTrack> tracks = photoTracks(scene, spacing);
    for (int keyframes : {1, 2}) {
        Hits hits;
        const ResourceMeter meter;
        for (const PhotoTrack &track : tracks)
            if (Result<void> added = add(*shot, track, keyframes, hits); !added)
                return added;
        const auto percent = [](int part, int whole) { return 100.0 * part / std::max(1, whole); };
        const double near[] = {percent(hits.within[0], hits.seen), percent(hits.within[1], hits.seen),
                               percent(hits.within[2], hits.seen)};
        table.add({scene.name, std::to_string(keyframes), double(hits.tracks), near[0], near[1], near[2],
                   (near[0] + near[1] + near[2]) / 3.0, percent(hits.rightlyTold, hits.told),
                   1000.0 * meter.used().cpuSeconds / std::max(1, hits.tracks)});
    }
    return {};
}

} // namespace

int runPhotoSection(const std::filesystem::path &data, nlohmann::ordered_json &report, std::ostream &out)
{
    const Result<std::vector<PhotoScene>> scenes = photoScenes(data);
    if (!scenes) {
        out << "Filmed things with a truth: left out, " << scenes.error().problem << "\n";
        return 0;
    }
    Table table(out, "Filmed things that we move (cut out of DAVIS; % within 4, 8, 16 of 256 pixels)",
                {{"scene", "scene", 10, 0},
                 {"keyframes", "keyframes", 10, 0},
                 {"tracks", "tracks", 7, 0},
                 {"delta4", "4", 7, 1},
                 {"delta8", "8", 7, 1},
                 {"delta16", "16", 7, 1},
                 {"delta", "mean", 7, 1},
                 {"occlusion", "OA", 7, 1},
                 {"milliseconds", "ms/track", 9, 0}});
    for (const PhotoScene &scene : *scenes)
        if (Result<void> added = addRows(scene, table); !added)
            table.addFailure(scene.name, added.error().problem);
    table.note(
        "Looks and edges are filmed, motion, limbs' swing, smear and light are ours, so the truth is exact.");
    report["photos"] = table.json();
    return table.failures();
}

} // namespace ductus
