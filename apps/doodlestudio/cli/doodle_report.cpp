#include "doodlestudio/cli/doodle_report.h"

#include <cstdio>

namespace ductus {

namespace {

struct Counts
{
    std::size_t keyframes = 0, frames = 0, marks = 0;
};

Counts countsOf(const Canvas &canvas)
{
    const CanvasKeyframes &keys = canvas.keyframes;
    Counts counts{keys.positions.size() + keys.depths.size() + keys.turns.size() + keys.scales.size(),
                  canvas.doodle.frames.size(), 0};
    for (const DoodleFrame &frame : canvas.doodle.frames)
        counts.marks += frame.marks.size();
    return counts;
}

const char *motionName(const Canvas &canvas)
{
    return canvas.motion == CanvasMotion::Static ? "static" : "dynamic";
}

std::string many(std::size_t count, const char *what)
{
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

} // namespace

nlohmann::ordered_json doodleSummary(const DoodleContent &content)
{
    const ClipReference &clip = content.clip();
    nlohmann::ordered_json json = {{"clip", clip.path},
                                   {"frames", clip.frameCount},
                                   {"width", clip.width},
                                   {"height", clip.height},
                                   {"framesPerSecond", clip.framesPerSecond},
                                   {"canvases", nlohmann::ordered_json::array()}};
    for (const Canvas &canvas : content.scene()->canvases) {
        const Counts counts = countsOf(canvas);
        json["canvases"].push_back({{"name", canvas.name},
                                    {"motion", motionName(canvas)},
                                    {"visible", canvas.isVisible},
                                    {"keyframes", counts.keyframes},
                                    {"frames", counts.frames},
                                    {"marks", counts.marks}});
        if (canvas.prop)
            json["canvases"].back()["painting"] = {{"name", canvas.prop->link.name},
                                                   {"file", canvas.prop->link.file},
                                                   {"look", canvas.prop->look}};
    }
    return json;
}

std::string doodleLines(const DoodleContent &content)
{
    const ClipReference &clip = content.clip();
    char rate[32];
    std::snprintf(rate, sizeof rate, "%.4g", clip.framesPerSecond);
    std::string text = "  clip " + clip.path + ": " + many(std::size_t(clip.frameCount), "frame") + " of " +
                       std::to_string(clip.width) + " x " + std::to_string(clip.height) + ", " + rate +
                       " a second\n";
    for (const Canvas &canvas : content.scene()->canvases) {
        const Counts counts = countsOf(canvas);
        text += "  canvas \"" + canvas.name + "\", " + motionName(canvas) +
                (canvas.isVisible ? "" : ", hidden") + ": " + many(counts.keyframes, "keyframe") + ", " +
                many(counts.frames, "drawn frame") + ", " + many(counts.marks, "mark") +
                (canvas.prop ? ", the painting \"" + canvas.prop->link.name + "\"" : "") + "\n";
    }
    return text;
}

} // namespace ductus
