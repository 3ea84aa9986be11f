#include "doodling/storage/canvas_storage.h"

#include "doodling/storage/mark_storage.h"
#include "doodling/storage/prop_storage.h"
#include "painting/storage/array_slots.h"
#include "project/container/entry_name.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double largest = 1e12;
constexpr double smallest = 1e-12;
constexpr std::size_t mostCanvases = 4096;
constexpr std::size_t mostKeyframes = 1000000;
constexpr std::size_t mostMarks = 1000000;
constexpr std::size_t longestName = 1024;
constexpr int mostFrames = 1000000;

constexpr std::pair<std::string_view, CanvasMotion> motionNames[] = {{"static", CanvasMotion::Static},
                                                                     {"dynamic", CanvasMotion::Dynamic}};
constexpr std::pair<std::string_view, CanvasTurning> turningNames[] = {
    {"along-path", CanvasTurning::AlongPath},
    {"still", CanvasTurning::Still},
    {"with-thing", CanvasTurning::WithThing}};
constexpr std::pair<std::string_view, DoodleRepeat> repeatNames[] = {{"loop", DoodleRepeat::Loop},
                                                                     {"ping-pong", DoodleRepeat::PingPong},
                                                                     {"once", DoodleRepeat::Once},
                                                                     {"hold-last", DoodleRepeat::HoldLast}};

template <typename T, std::size_t N>
std::string_view nameOf(T wanted, const std::pair<std::string_view, T> (&names)[N])
{
    for (const auto &[name, value] : names)
        if (value == wanted)
            return name;
    return names[0].first;
}

OrderedJson keyframesJson(const CanvasKeyframes &keyframes)
{
    OrderedJson json = {{"positions", OrderedJson::array()},
                        {"depths", OrderedJson::array()},
                        {"turns", OrderedJson::array()},
                        {"scales", OrderedJson::array()}};
    for (const CanvasKeyframe &key : keyframes.positions) {
        OrderedJson one = {{"frame", key.frame}, {"x", key.pixel.x()}, {"y", key.pixel.y()}};
        if (key.depth)
            one["depth"] = *key.depth;
        one["interpolatesNext"] = key.interpolatesNext;
        json["positions"].push_back(std::move(one));
    }
    for (const DepthKeyframe &key : keyframes.depths)
        json["depths"].push_back({{"frame", key.frame}, {"depth", key.depth}});
    for (const TurnKeyframe &key : keyframes.turns) {
        const Eigen::Quaterniond &q = key.worldFromCanvas;
        json["turns"].push_back({{"frame", key.frame},
                                 {"rotation", OrderedJson::array({q.x(), q.y(), q.z(), q.w()})},
                                 {"interpolatesNext", key.interpolatesNext}});
    }
    for (const ScaleKeyframe &key : keyframes.scales)
        json["scales"].push_back({{"frame", key.frame}, {"scale", key.scale}});
    return json;
}

OrderedJson occlusionJson(const CanvasOcclusion &occlusion, ArrayPass &pass)
{
    OrderedJson json = {{"on", occlusion.isOn},
                        {"bias", occlusion.bias},
                        {"softness", occlusion.softness},
                        {"touches", OrderedJson::array()}};
    for (const OcclusionTouch &touch : occlusion.touches)
        json["touches"].push_back({{"frame", touch.frame},
                                   {"radius", touch.radius},
                                   {"front", touch.isCanvasInFront},
                                   {"reach", touch.reach},
                                   {"line", planePoints(touch.line, "px", pass)}});
    return json;
}

OrderedJson doodleJson(const Doodle &doodle, ArrayPass &pass)
{
    OrderedJson json = {{"repeat", nameOf(doodle.repeat, repeatNames)},
                        {"offset", doodle.offset},
                        {"frames", OrderedJson::array()}};
    for (const DoodleFrame &frame : doodle.frames) {
        OrderedJson marks = OrderedJson::array();
        for (const MarkPointer &mark : frame.marks)
            marks.push_back(markJson(*mark, pass));
        json["frames"].push_back({{"hold", frame.hold}, {"marks", std::move(marks)}});
    }
    return json;
}

OrderedJson canvasJson(const Canvas &canvas, ArrayPass &pass)
{
    return {{"id", canvas.id.value},
            {"name", canvas.name},
            {"motion", nameOf(canvas.motion, motionNames)},
            {"turning", nameOf(canvas.turning, turningNames)},
            {"size", OrderedJson::array({canvas.size.x(), canvas.size.y()})},
            {"visible", canvas.isVisible},
            {"opacity", canvas.opacity},
            {"shownFrom", canvas.shownFrom},
            {"shownUntil", canvas.shownUntil},
            {"keyframes", keyframesJson(canvas.keyframes)},
            {"occlusion", occlusionJson(canvas.occlusion, pass)},
            {"doodle", doodleJson(canvas.doodle, pass)}};
}

OrderedJson written(const DoodleScene &scene, ArrayPass pass)
{
    OrderedJson canvases = OrderedJson::array();
    for (const Canvas &canvas : scene.canvases)
        canvases.push_back(canvasJson(canvas, pass));
    return {{"canvases", std::move(canvases)}};
}

// Calls \a read for each keyframe; they must ascend and lie within the clip.
template <typename Read>
void readKeyframes(const JsonReader &reader, std::string_view key, int frameCount, const Read &read)
{
    int last = -1;
    for (const JsonReader &one : reader.elements(key, mostKeyframes)) {
        const int frame = int(one.integer("frame", 0, frameCount - 1));
        if (!reader.failed() && frame <= last)
            one.failAt("frame", "keyframes do not ascend");
        if (reader.failed())
            return;
        last = frame;
        read(one, frame);
    }
}

CanvasKeyframes keyframesFrom(const JsonReader &reader, int frameCount)
{
    CanvasKeyframes keyframes;
    readKeyframes(reader, "positions", frameCount, [&](const JsonReader &one, int frame) {
        CanvasKeyframe key;
        key.frame = frame;
        key.pixel = Vec2(one.number("x", -largest, largest), one.number("y", -largest, largest));
        if (one.has("depth"))
            key.depth = one.number("depth", smallest, largest);
        key.interpolatesNext = one.boolean("interpolatesNext");
        keyframes.positions.push_back(key);
    });
    readKeyframes(reader, "depths", frameCount, [&](const JsonReader &one, int frame) {
        keyframes.depths.push_back({frame, one.number("depth", smallest, largest)});
    });
    readKeyframes(reader, "turns", frameCount, [&](const JsonReader &one, int frame) {
        const std::vector<double> q = one.numbers("rotation", 4);
        if (reader.failed())
            return;
        TurnKeyframe key;
        key.frame = frame;
        key.worldFromCanvas = Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
        key.interpolatesNext = one.boolean("interpolatesNext");
        if (std::abs(key.worldFromCanvas.norm() - 1.0) > 1e-6)
            one.failAt("rotation", "it is no rotation");
        keyframes.turns.push_back(key);
    });
    readKeyframes(reader, "scales", frameCount, [&](const JsonReader &one, int frame) {
        keyframes.scales.push_back({frame, one.number("scale", smallest, largest)});
    });
    if (!reader.failed() && keyframes.positions.empty())
        reader.failAt("positions", "the canvas has no place in any frame");
    return keyframes;
}

CanvasOcclusion occlusionFrom(const JsonReader &reader, ArrayLoader &arrays, int frameCount)
{
    CanvasOcclusion occlusion;
    occlusion.isOn = reader.boolean("on");
    occlusion.bias = reader.number("bias", -1.0, 1.0);
    occlusion.softness = reader.number("softness", 0.0, 1.0);
    for (const JsonReader &one : reader.elements("touches", mostMarks)) {
        if (reader.failed())
            break;
        OcclusionTouch touch;
        touch.frame = int(one.integer("frame", 0, frameCount - 1));
        touch.radius = one.number("radius", smallest, largest);
        touch.isCanvasInFront = one.boolean("front");
        touch.reach = int(one.integer("reach", 0, mostFrames));
        touch.line = planePointsFrom(one, "line", arrays);
        occlusion.touches.push_back(std::move(touch));
    }
    return occlusion;
}

Doodle doodleFrom(const JsonReader &reader, ArrayLoader &arrays)
{
    Doodle doodle;
    doodle.repeat = reader.oneOf<DoodleRepeat>("repeat", repeatNames);
    doodle.offset = int(reader.integer("offset", -mostFrames, mostFrames));
    doodle.frames.clear();
    for (const JsonReader &one : reader.elements("frames", std::size_t(mostFrames))) {
        DoodleFrame frame;
        frame.hold = int(one.integer("hold", 1, mostFrames));
        for (const JsonReader &mark : one.elements("marks", mostMarks)) {
            if (reader.failed())
                return doodle;
            frame.marks.push_back(std::make_shared<const DoodleMark>(markFromJson(mark, arrays)));
        }
        doodle.frames.push_back(std::move(frame));
    }
    if (!reader.failed() && doodle.frames.empty())
        reader.failAt("frames", "there is none");
    return doodle;
}

Canvas canvasFrom(const JsonReader &reader, ArrayLoader &arrays, int frameCount)
{
    Canvas canvas;
    canvas.id = {std::int32_t(reader.integer("id", 0, INT32_MAX - 1))};
    canvas.name = reader.string("name", longestName);
    canvas.motion = reader.oneOf<CanvasMotion>("motion", motionNames);
    canvas.turning = reader.oneOf<CanvasTurning>("turning", turningNames);
    const std::vector<double> size = reader.numbers("size", 2);
    if (!reader.failed())
        canvas.size = Vec2(size[0], size[1]);
    if (!(canvas.size.minCoeff() > 0.0))
        reader.failAt("size", "it is not positive");
    canvas.isVisible = reader.boolean("visible");
    canvas.opacity = reader.number("opacity", 0.0, 1.0);
    canvas.shownFrom = int(reader.integer("shownFrom", 0, mostFrames));
    canvas.shownUntil = int(reader.integer("shownUntil", -1, mostFrames));
    if (reader.failed())
        return canvas;
    canvas.keyframes = keyframesFrom(reader.member("keyframes"), frameCount);
    canvas.occlusion = occlusionFrom(reader.member("occlusion"), arrays, frameCount);
    if (!reader.failed())
        canvas.doodle = doodleFrom(reader.member("doodle"), arrays);
    if (!reader.failed() && reader.has("prop"))
        canvas.prop = propFromJson(reader.member("prop"), arrays);
    return canvas;
}

} // namespace

StoredScene addScene(const DoodleScene &scene, BufferPacker &packer)
{
    StoredScene stored;
    written(scene, ArrayPass(packer, stored.arrays));
    for (const Canvas &canvas : scene.canvases)
        if (canvas.prop)
            stored.paintings[canvas.id] = propJsonWithSlots(*canvas.prop, packer);
    return stored;
}

OrderedJson sceneJson(const DoodleScene &scene, const StoredScene &stored, const BufferPacker &packer)
{
    OrderedJson json = written(scene, ArrayPass(packer, stored.arrays));
    for (std::size_t i = 0; i < scene.canvases.size(); ++i)
        if (scene.canvases[i].prop) {
            OrderedJson &prop = json["canvases"][i]["prop"] = stored.paintings.at(scene.canvases[i].id);
            resolveArrays(prop, packer);
        }
    return json;
}

DoodleScene sceneFromJson(const JsonReader &reader, ArrayLoader &arrays, int frameCount)
{
    DoodleScene scene;
    for (const JsonReader &one : reader.elements("canvases", mostCanvases)) {
        if (reader.failed())
            break;
        Canvas canvas = canvasFrom(one, arrays, frameCount);
        if (!reader.failed() && scene.find(canvas.id))
            one.failAt("id", "two canvases have the same");
        scene.canvases.push_back(std::move(canvas));
    }
    return scene;
}

std::string sceneProblem(const DoodleScene &scene, int frameCount)
{
    for (const Canvas &canvas : scene.canvases) {
        if (!isValidUtf8(canvas.name) || canvas.name.size() > longestName)
            return "the name of a canvas is too long or not UTF-8";
        if (canvas.keyframes.positions.empty())
            return "the canvas \"" + canvas.name + "\" has no place in any frame";
        const auto isWithin = [&](const auto &keyframes) {
            int last = -1;
            for (const auto &key : keyframes) {
                if (key.frame <= last || key.frame >= frameCount)
                    return false;
                last = key.frame;
            }
            return true;
        };
        if (!isWithin(canvas.keyframes.positions) || !isWithin(canvas.keyframes.depths) ||
            !isWithin(canvas.keyframes.turns) || !isWithin(canvas.keyframes.scales))
            return "keyframes of the canvas \"" + canvas.name + "\" are out of order or beyond the clip";
        for (const OcclusionTouch &touch : canvas.occlusion.touches)
            if (touch.frame < 0 || touch.frame >= frameCount)
                return "the occlusion brush of the canvas \"" + canvas.name + "\" is beyond the clip";
        if (canvas.prop)
            if (const std::string problem = storedPropProblem(*canvas.prop); !problem.empty())
                return problem + " (canvas \"" + canvas.name + "\")";
        for (const DoodleFrame &frame : canvas.doodle.frames)
            for (const MarkPointer &mark : frame.marks)
                if (const TextMark *text = std::get_if<TextMark>(mark.get());
                    text && !isValidUtf8(text->text))
                    return "words on the canvas \"" + canvas.name + "\" are not UTF-8";
    }
    return {};
}

} // namespace ductus
