#include "formats/paintings/quill_layer.h"

#include "formats/paintings/object_fields.h"
#include "formats/paintings/object_stream.h"
#include "formats/text/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ductus {

using Json = nlohmann::json;

namespace {

constexpr double ticksPerSecond = 12600;

/// Reading of one layer: what is wrong goes to the fault, what was put right to the notes.
struct LayerReading
{
    std::string name;
    std::optional<std::string> fault;
    bool hasMatrices = false;
    std::vector<std::string> &notes;

    void note(const std::string &text)
    {
        std::string line = "layer \"" + name + "\": " + text;
        if (notes.empty() || notes.back() != line) // thousands of keys may have the same fault
            notes.push_back(std::move(line));
    }
};

double unitRange(double value, const char *what, LayerReading &reading)
{
    if (value >= 0 && value <= 1)
        return value;
    reading.note(std::string(what) + " was outside 0..1");
    return std::clamp(value, 0.0, 1.0);
}

PaintingFileFlip flipOf(const std::string &text, LayerReading &reading)
{
    if (text == "X")
        return PaintingFileFlip::X;
    if (text == "Y")
        return PaintingFileFlip::Y;
    if (text == "Z")
        return PaintingFileFlip::Z;
    if (text != "N" && !reading.fault)
        reading.fault = "Flip is none of N, X, Y, Z";
    return PaintingFileFlip::None;
}

PaintingFileTransform transformOf(const Json &value, LayerReading &reading)
{
    PaintingFileTransform transform;
    if (value.is_array()) {
        reading.hasMatrices = true; // their order of rows and columns is not known for certain
        return transform;
    }
    if (!value.is_object()) {
        if (!reading.fault)
            reading.fault = "a transform is no object";
        return transform;
    }
    const ObjectFields fields(value, reading.fault);
    double rotation[4] = {0, 0, 0, 1};
    fields.numbers("Rotation", rotation, 4);
    const Eigen::Quaterniond q(rotation[3], rotation[0], rotation[1], rotation[2]);
    const double length = q.norm();
    if (length > 1e-6 && std::isfinite(length))
        transform.rotation = Eigen::Quaterniond(q.coeffs() / length);
    else
        reading.note("a rotation of no length was taken as none");
    transform.scale = fields.number("Scale", 1.0);
    transform.flip = flipOf(fields.text("Flip", "N"), reading);
    fields.numbers("Translation", transform.translation.data(), 3);
    if (std::abs(transform.scale) > largestCoordinate ||
        transform.translation.cwiseAbs().maxCoeff() > largestCoordinate)
        fields.fault("a transform is beyond all bounds");
    return transform;
}

PaintingFileInterpolation interpolationOf(const std::string &text, LayerReading &reading)
{
    using Interpolation = PaintingFileInterpolation;
    static constexpr std::pair<std::string_view, Interpolation> names[] = {
        {"None", Interpolation::None},
        {"Linear", Interpolation::Linear},
        {"EaseIn", Interpolation::EaseIn},
        {"EaseOut", Interpolation::EaseOut},
        {"Smoothstep", Interpolation::SmoothStep}};
    for (const auto &[name, value] : names)
        if (text == name)
            return value;
    reading.note("the interpolation \"" + text + "\" is not known and was taken as linear");
    return Interpolation::Linear;
}

template <typename T, typename ValueOf>
void readKeys(const ObjectFields &lists, const char *name, std::vector<PaintingFileKey<T>> &keys,
              LayerReading &reading, const ValueOf &valueOf)
{
    const Json *list = lists.array(name);
    if (!list)
        return;
    for (const Json &item : *list) {
        if (!item.is_object() || !item.contains("Value")) {
            lists.fault(std::string("a key of ") + name + " is no object with a value");
            return;
        }
        const ObjectFields fields(item, reading.fault);
        PaintingFileKey<T> key;
        key.timeSeconds = fields.numberOrText("Time", 0) / ticksPerSecond;
        key.interpolation = interpolationOf(fields.text("Interpolation", "None"), reading);
        key.value = valueOf(fields, item["Value"]);
        keys.push_back(key);
    }
    const auto earlier = [](const auto &a, const auto &b) { return a.timeSeconds < b.timeSeconds; };
    std::stable_sort(keys.begin(), keys.end(), earlier);
}

void readAnimation(const Json &object, PaintingFileAnimation &animation, LayerReading &reading)
{
    const ObjectFields fields(object, reading.fault);
    animation.hasOwnTimeline = fields.boolean("Timeline", false);
    animation.durationSeconds = fields.numberOrText("Duration", 0) / ticksPerSecond;
    animation.startOffsetSeconds = fields.numberOrText("StartOffset", 0) / ticksPerSecond;
    animation.repeatCount = std::max(0, fields.integerOrText("MaxRepeatCount", 0));
    const Json *keys = fields.object("Keys");
    if (!keys)
        return;
    const ObjectFields lists(*keys, reading.fault);
    readKeys(lists, "Visibility", animation.visibility, reading,
             [](const ObjectFields &key, const Json &) { return key.boolean("Value", true); });
    readKeys(lists, "Opacity", animation.opacity, reading, [&](const ObjectFields &key, const Json &) {
        return unitRange(key.number("Value", 1), "the opacity of a key", reading);
    });
    readKeys(lists, "Offset", animation.offsetSeconds, reading, [](const ObjectFields &key, const Json &) {
        return key.numberOrText("Value", 0) / ticksPerSecond;
    });
    readKeys(lists, "Transform", animation.transform, reading,
             [&](const ObjectFields &, const Json &value) { return transformOf(value, reading); });
}

/// A place in Quill.qbin: 8 to 16 hexadecimal digits.
std::optional<std::uint64_t> offsetOf(const Json &value)
{
    if (!value.is_string())
        return std::nullopt;
    const std::string &digits = value.get_ref<const std::string &>();
    std::uint64_t offset = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), offset, 16);
    if (digits.size() < 8 || digits.size() > 16 || code != std::errc() ||
        end != digits.data() + digits.size())
        return std::nullopt;
    return offset;
}

std::optional<std::uint64_t> dataOffset(const ObjectFields &fields)
{
    const Json *value = fields.find("DataFileOffset");
    if (!value)
        return std::nullopt;
    const std::optional<std::uint64_t> offset = offsetOf(*value);
    if (!offset)
        fields.fault("DataFileOffset is not made of 8 to 16 hexadecimal digits");
    return offset;
}

void readFrames(const ObjectFields &fields, QuillLayer &layer, LayerReading &reading)
{
    const int drawings = int(layer.drawingOffsets.size());
    if (const Json *frames = fields.array("Frames")) {
        for (const Json &frame : *frames) {
            const std::optional<double> index = numberIn(frame);
            if (!index || *index != std::floor(*index) || *index < 0 || *index >= drawings) {
                fields.fault("Frames names a drawing that is not there");
                return;
            }
            layer.layer.frames.push_back(int(*index));
        }
    }
    if (layer.layer.frames.empty() && drawings > 0) {
        layer.layer.frames = {0};
        if (drawings > 1)
            reading.note("it has drawings but no frames; the first drawing was taken");
    }
}

void readPaint(const ObjectFields &fields, QuillLayer &layer, LayerReading &reading)
{
    PaintingFileLayer &paint = layer.layer;
    paint.framesPerSecond = fields.number("Framerate", 24);
    if (!(paint.framesPerSecond > 0 && paint.framesPerSecond <= 1000)) {
        reading.note("a frame rate of no use was taken as 24");
        paint.framesPerSecond = 24;
    }
    paint.frameRepeatCount = std::max(0, fields.integerOrText("MaxRepeatCount", 0));
    if (const Json *drawings = fields.array("Drawings")) {
        for (const Json &drawing : *drawings) {
            const auto offset = drawing.is_object() && drawing.contains("DataFileOffset")
                                    ? offsetOf(drawing["DataFileOffset"])
                                    : std::nullopt;
            if (!offset) {
                fields.fault("the DataFileOffset of a drawing is not made of 8 to 16 hexadecimal digits");
                return;
            }
            layer.drawingOffsets.push_back(*offset);
        }
    } else if (const auto offset = dataOffset(fields)) { // Quill 1.3
        layer.drawingOffsets.push_back(*offset);
    }
    readFrames(fields, layer, reading);
}

void readImplementation(const Json &object, QuillLayerRecord &record, LayerReading &reading)
{
    QuillLayer &layer = record.layer;
    const ObjectFields fields(object, reading.fault);
    if (layer.type == "Group") {
        layer.layer.kind = PaintingFileLayerKind::Group;
        const Json *children = fields.array("Children");
        for (std::size_t i = 0; children && i < children->size(); ++i) {
            const auto number = takenOutNumber((*children)[i]);
            if (!number)
                fields.fault("child " + std::to_string(i) + " of the group is no layer");
            else
                record.children.push_back(*number);
        }
    } else if (layer.type == "Paint") {
        layer.layer.kind = PaintingFileLayerKind::Paint;
        readPaint(fields, layer, reading);
    } else if (layer.type == "Picture") {
        layer.layer.kind = PaintingFileLayerKind::Picture;
        layer.layer.pictureType = fields.text("Type", "2D");
        layer.dataOffset = dataOffset(fields);
    } else {
        layer.layer.kind = PaintingFileLayerKind::Other;
    }
}

} // namespace

bool isQuillLayer(const Json &object)
{
    const auto type = object.find("Type");
    const auto implementation = object.find("Implementation");
    return type != object.end() && type->is_string() && implementation != object.end() &&
           implementation->is_object();
}

Result<QuillLayerRecord> quillLayer(const Json &object, const std::string &place,
                                    std::vector<std::string> &notes)
{
    QuillLayerRecord record;
    PaintingFileLayer &layer = record.layer.layer;
    LayerReading reading{"", std::nullopt, false, notes};
    const ObjectFields fields(object, reading.fault);
    layer.name = reading.name = fields.text("Name", "");
    record.layer.type = fields.text("Type", "");
    layer.visible = fields.boolean("Visible", true);
    layer.locked = fields.boolean("Locked", false);
    layer.opacity = unitRange(fields.number("Opacity", 1), "its opacity", reading);
    if (const Json *transform = fields.find("Transform"))
        layer.transform = transformOf(*transform, reading);
    if (const Json *pivot = fields.find("Pivot"))
        layer.pivot = transformOf(*pivot, reading);
    if (const Json *animation = fields.object("Animation"))
        readAnimation(*animation, layer.animation, reading);
    readImplementation(object["Implementation"], record, reading);

    const std::string where = place + ": layer \"" + layer.name + "\"";
    if (reading.fault)
        return Error{ErrorCode::Malformed, "Reading the painting", *reading.fault,
                     "Save it again in Quill, or mend that layer in a text editor", where};
    if (reading.hasMatrices)
        return Error{ErrorCode::Unsupported, "Reading the painting",
                     "its transforms are matrices, as Quill 1.3 and earlier wrote them",
                     "Open it in a later Quill and save it", where};
    return record;
}

} // namespace ductus
