#include "doodling/export/timeline_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace ductus {

namespace {

using Json = nlohmann::ordered_json;

class TimelineWriter
{
public:
    TimelineWriter(const ClipReference &clip, const Shot &shot) : mClip(clip), mShot(shot) {}

    Json range(int from, int count) const
    {
        return {{"OTIO_SCHEMA", "TimeRange.1"}, {"start_time", time(from)}, {"duration", time(count)}};
    }

    Json clip(const std::string &name, int count, Json media, Json markers, Json metadata) const
    {
        return {{"OTIO_SCHEMA", "Clip.1"},
                {"name", name},
                {"source_range", range(0, count)},
                {"effects", Json::array()},
                {"markers", std::move(markers)},
                {"media_reference", std::move(media)},
                {"metadata", {{"ductus", std::move(metadata)}}}};
    }

    Json track(const std::string &name, Json children) const
    {
        return {{"OTIO_SCHEMA", "Track.1"},
                {"name", name},
                {"kind", "Video"},
                {"source_range", nullptr},
                {"effects", Json::array()},
                {"markers", Json::array()},
                {"metadata", Json::object()},
                {"children", std::move(children)}};
    }

    Json canvasTrack(const Canvas &canvas) const
    {
        const int last = mClip.frameCount - 1;
        const int from = std::clamp(canvas.shownFrom, 0, last);
        const int until = canvas.shownUntil < 0 ? last : std::clamp(canvas.shownUntil, from, last);
        Json children = Json::array();
        if (from > 0)
            children.push_back({{"OTIO_SCHEMA", "Gap.1"},
                                {"name", ""},
                                {"source_range", range(0, from)},
                                {"effects", Json::array()},
                                {"markers", Json::array()},
                                {"metadata", Json::object()}});
        const Json media = {{"OTIO_SCHEMA", "MissingReference.1"},
                            {"name", ""},
                            {"available_range", nullptr},
                            {"metadata", Json::object()}};
        const Json metadata = {{"motion", canvas.motion == CanvasMotion::Dynamic ? "follows" : "stays"},
                               {"size", {canvas.size.x(), canvas.size.y()}},
                               {"opacity", canvas.opacity},
                               {"visible", canvas.isVisible},
                               {"drawings", canvas.doodle.frames.size()}};
        children.push_back(clip(canvas.name, until - from + 1, media, markers(canvas, from), metadata));
        return track(canvas.name, std::move(children));
    }

private:
    Json time(int frames) const
    {
        return {
            {"OTIO_SCHEMA", "RationalTime.1"}, {"rate", mClip.framesPerSecond}, {"value", double(frames)}};
    }

    // \a from: the canvas' first frame; markers count from the clip they stand on.
    Json marker(const std::string &name, const char *colour, int frame, int from, Json metadata) const
    {
        metadata["frame"] = frame;
        return {{"OTIO_SCHEMA", "Marker.2"},
                {"name", name},
                {"color", colour},
                {"marked_range", range(frame - from, 1)},
                {"metadata", {{"ductus", std::move(metadata)}}}};
    }

    Json markers(const Canvas &canvas, int from) const
    {
        Json all = Json::array();
        const double clipPixels = 1.0 / mShot.scale();
        for (const CanvasKeyframe &key : canvas.keyframes.positions) {
            Json data = {{"pixel", {key.pixel.x() * clipPixels, key.pixel.y() * clipPixels}},
                         {"straight", key.interpolatesNext}};
            if (key.depth)
                data["depth"] = *key.depth;
            all.push_back(marker("pin", "RED", key.frame, from, std::move(data)));
        }
        for (const DepthKeyframe &key : canvas.keyframes.depths)
            all.push_back(marker("distance", "BLUE", key.frame, from, {{"depth", key.depth}}));
        for (const TurnKeyframe &key : canvas.keyframes.turns) {
            const Eigen::Quaterniond &q = key.worldFromCanvas;
            all.push_back(
                marker("turn", "GREEN", key.frame, from, {{"rotation", {q.x(), q.y(), q.z(), q.w()}}}));
        }
        for (const ScaleKeyframe &key : canvas.keyframes.scales)
            all.push_back(marker("size", "YELLOW", key.frame, from, {{"scale", key.scale}}));
        return all;
    }

    const ClipReference &mClip;
    const Shot &mShot;
};

} // namespace

std::string timelineText(const std::string &name, const std::string &clipUrl, const ClipReference &clip,
                         const Shot &shot, const DoodleScene &scene)
{
    const TimelineWriter writer(clip, shot);
    const Json media = {{"OTIO_SCHEMA", "ExternalReference.1"},
                        {"name", ""},
                        {"target_url", clipUrl},
                        {"available_range", writer.range(0, clip.frameCount)},
                        {"metadata", Json::object()}};
    const Json size = {{"width", clip.width}, {"height", clip.height}};
    Json tracks = Json::array();
    tracks.push_back(
        writer.track("clip", Json::array({writer.clip(name, clip.frameCount, media, Json::array(), size)})));
    for (const Canvas &canvas : scene.canvases)
        tracks.push_back(writer.canvasTrack(canvas));
    const Json timeline = {{"OTIO_SCHEMA", "Timeline.1"},
                           {"name", name},
                           {"global_start_time", nullptr},
                           {"metadata", {{"ductus", {{"generator", "DoodleStudio"}}}}},
                           {"tracks",
                            {{"OTIO_SCHEMA", "Stack.1"},
                             {"name", "tracks"},
                             {"source_range", nullptr},
                             {"effects", Json::array()},
                             {"markers", Json::array()},
                             {"metadata", Json::object()},
                             {"children", std::move(tracks)}}}};
    return timeline.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace ductus
