// .tilt: data.sketch (strokes) and metadata.json (brushes, layers) of Tilt Brush and Open Brush.
// quill-and-tilt.md section 4.
#include "formats/paintings/object_fields.h"
#include "formats/paintings/object_stream.h"
#include "formats/paintings/painting_readers.h"
#include "formats/paintings/tilt_environment.h"

#include <bit>
#include <cmath>
#include <map>

namespace ductus {

using Json = nlohmann::json;

namespace {

constexpr char attempted[] = "Reading the painting";
constexpr std::uint32_t sketchMagic = 0xC576A5CD;
constexpr std::int32_t knownVersion = 5;
constexpr std::uint64_t smallestStroke = 36;
constexpr std::uint32_t pointCore = 28;  // position and orientation
constexpr float largestPosition = 1e18f; // squares stay finite in single precision

enum StrokeBit : std::uint32_t { Flags = 1, Scale = 2, Group = 4, Seed = 8, LayerBit = 16 };
enum PointBit : std::uint32_t { Pressure = 1, Timestamp = 2 };

struct Metadata
{
    std::vector<std::string> brushes;
    std::vector<PaintingFileLayer> layers; // of Open Brush; only what the program is known to write
    std::vector<std::string> notes;
    std::optional<TiltEnvironment> environment;
};

struct StrokeHeader
{
    std::int32_t brush;
    float rgba[4];
    float size;
    std::uint32_t strokeMask;
    std::uint32_t pointMask;
};
static_assert(sizeof(StrokeHeader) == 32 && std::endian::native == std::endian::little);

float linearFromEncoded(float value)
{
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

Result<Metadata> readMetadata(ByteSource &json, const JobControl &control)
{
    const Result<Json> root = readObjectStream(json, {}, attempted, control);
    if (!root)
        return root.error();
    std::optional<std::string> fault;
    Metadata metadata;
    if (!root->is_object())
        fault = "it is no object";
    const ObjectFields fields(*root, fault);
    const Json *brushes = fault ? nullptr : fields.array("BrushIndex");
    for (std::size_t i = 0; brushes && i < brushes->size(); ++i) {
        const Json &brush = (*brushes)[i];
        if (!brush.is_string())
            fields.fault("BrushIndex holds something else than texts");
        metadata.brushes.push_back(brush.is_string() ? brush.get<std::string>() : "");
    }
    if (fault)
        return Error{ErrorCode::Malformed, attempted, *fault, "Save the sketch again", json.name()};
    std::optional<std::string> unknown; // surroundings of another kind are no fault of the sketch
    metadata.environment = tiltEnvironment(ObjectFields(*root, unknown).text("EnvironmentPreset", ""));
    const Json *layers = fields.find("Layers");
    for (std::size_t i = 0; layers && layers->is_array() && i < layers->size(); ++i) {
        PaintingFileLayer layer;
        std::optional<std::string> ignored; // a layer without a name gets one later
        if ((*layers)[i].is_object()) {
            const ObjectFields of((*layers)[i], ignored);
            layer.name = of.text("Name", "");
            layer.visible = of.boolean("Visible", true);
            layer.locked = of.boolean("Locked", false);
            if (of.find("Transform"))
                metadata.notes.push_back("layer " + std::to_string(i) +
                                         ": the placement of the layer as a whole is not applied");
        }
        metadata.layers.push_back(std::move(layer));
    }
    return metadata;
}

/// What else a stroke says, by the bits of its mask.
struct StrokeExtras
{
    float scale = 1;
    std::uint32_t group = 0;
    std::uint32_t layer = 0;
};

class SketchReading
{
public:
    SketchReading(ByteSource &sketch, const Metadata &metadata, const PaintingReadOptions &options)
        : mBytes(sketch, 0), mMetadata(metadata), mOptions(options)
    {
    }

    std::map<std::uint32_t, PaintingFileDrawing> layers; // by index
    std::int64_t strokes = 0;
    std::int64_t points = 0;
    std::int64_t clampedValues = 0;

    std::optional<Error> run(const JobControl &control)
    {
        std::uint32_t head[4] = {}; // magic, version, 0, size of more header
        if (const auto done = mBytes.read(std::as_writable_bytes(std::span(head))); !done)
            return done.error();
        if (head[0] != sketchMagic)
            return error(0, "this is no sketch: its first number is wrong", ErrorCode::Unsupported);
        if (head[1] != std::uint32_t(knownVersion))
            return error(4,
                         "the sketch is of version " + std::to_string(std::int32_t(head[1])) + ", only " +
                             std::to_string(knownVersion) + " is known",
                         ErrorCode::Unsupported);
        if (const auto done = mBytes.skip(head[3]); !done)
            return done.error();
        const std::uint64_t countPlace = mBytes.offset();
        const Result<std::int32_t> count = mBytes.read<std::int32_t>();
        if (!count)
            return count.error();
        if (*count < 0 || std::uint64_t(*count) > mBytes.remaining() / smallestStroke)
            return error(countPlace,
                         std::to_string(*count) + " strokes are announced, which the file cannot hold");
        for (std::int32_t s = 0; s < *count; ++s) {
            control.progress(double(s) / double(*count), attempted);
            if (control.isCancelled())
                return cancelledError(attempted);
            if (auto failed = readStroke())
                return failed;
        }
        strokes = *count;
        return std::nullopt;
    }

    std::uint64_t bytesLeft() const { return mBytes.remaining(); }

private:
    Error error(std::uint64_t place, std::string problem, ErrorCode code = ErrorCode::Malformed) const
    {
        return {code, attempted, std::move(problem), "Save the sketch again, or copy the file again",
                mBytes.source().place(place)};
    }

    std::optional<Error> readStroke()
    {
        const std::uint64_t begin = mBytes.offset();
        StrokeHeader header{};
        if (const auto done = mBytes.read(std::as_writable_bytes(std::span(&header, 1))); !done)
            return done.error();
        if (header.brush < 0 ||
            (!mMetadata.brushes.empty() && std::size_t(header.brush) >= mMetadata.brushes.size()))
            return error(begin, "a stroke has brush " + std::to_string(header.brush) +
                                    ", which metadata.json does not name");
        Result<StrokeExtras> extras = readExtras(header.strokeMask);
        if (!extras)
            return extras.error();
        PaintingFileStroke stroke;
        stroke.id = std::uint32_t(points); // the format has none; the first point's number is unique
        stroke.section = PaintingFileSection::Ribbon;
        stroke.group = extras->group;
        if (!mMetadata.brushes.empty())
            stroke.brush = mMetadata.brushes[std::size_t(header.brush)];
        PaintingFilePoint common;
        bool changed = false;
        for (int c = 0; c < 3; ++c)
            common.colour[c] = linearFromEncoded(inUnit(header.rgba[c], changed));
        common.opacity = inUnit(header.rgba[3], changed);
        clampedValues += changed;
        common.viewDirection.setZero();
        // Brush sizes are widths (inferred from the toolkit), the struct wants half of it.
        common.halfWidth = header.size * extras->scale / 2;
        if (!common.colour.allFinite() || !(common.halfWidth >= 0 && common.halfWidth <= largestPosition))
            return error(begin, "the colour or size of a stroke is no usable number");
        if (auto failed = readPoints(header.pointMask, common, stroke))
            return failed;
        layers[extras->layer].strokes.push_back(std::move(stroke));
        return std::nullopt;
    }

    float inUnit(float value, bool &changed)
    {
        changed = changed || value < 0 || value > 1;
        return std::isnan(value) ? value : std::min(std::max(value, 0.f), 1.f);
    }

    Result<StrokeExtras> readExtras(std::uint32_t mask)
    {
        StrokeExtras extras;
        for (int bit = 0; bit < 32; ++bit) {
            const std::uint32_t flag = 1u << bit;
            if (!(mask & flag))
                continue;
            const Result<std::uint32_t> value = mBytes.read<std::uint32_t>();
            if (!value)
                return value.error();
            if (flag == Scale)
                extras.scale = std::bit_cast<float>(*value);
            else if (flag == Group)
                extras.group = *value;
            else if (flag == LayerBit)
                extras.layer = *value;
            else if (bit >= 16) // of unknown meaning; the value is its size
                if (const auto done = mBytes.skip(*value); !done)
                    return done.error();
        }
        return extras;
    }

    std::optional<Error> readPoints(std::uint32_t mask, const PaintingFilePoint &common,
                                    PaintingFileStroke &stroke)
    {
        const std::uint64_t countPlace = mBytes.offset();
        const Result<std::int32_t> count = mBytes.read<std::int32_t>();
        if (!count)
            return count.error();
        const std::uint64_t pointSize = pointCore + 4 * std::uint64_t(std::popcount(mask));
        if (*count < 0 || std::uint64_t(*count) > mBytes.remaining() / pointSize)
            return error(countPlace, "a stroke of " + std::to_string(*count) +
                                         " points is announced, which the file cannot hold");
        points += *count;
        if (points > mOptions.maxPoints)
            return error(countPlace,
                         "the painting has more than " + std::to_string(mOptions.maxPoints) + " points",
                         ErrorCode::TooLarge);
        stroke.points.reserve(std::size_t(*count));
        for (std::int32_t i = 0; i < *count; ++i) {
            const std::uint64_t begin = mBytes.offset();
            if (const auto done = readPoint(mask, common, stroke); !done)
                return done.error();
            if (!isUsable(stroke.points.back()))
                return error(begin,
                             "point " + std::to_string(i) + " of a stroke has a number that is not finite");
        }
        return std::nullopt;
    }

    Result<void> readPoint(std::uint32_t mask, const PaintingFilePoint &common, PaintingFileStroke &stroke)
    {
        float core[7] = {};
        if (const auto done = mBytes.read(std::as_writable_bytes(std::span(core))); !done)
            return done.error();
        PaintingFilePoint point = common;
        // Unity's axes are left-handed: z changes its sign.
        point.position = {core[0], core[1], -core[2]};
        const Eigen::Quaternionf orientation(core[6], core[3], core[4], core[5]);
        const float length = orientation.norm();
        if (length > 1e-6f && std::isfinite(length)) {
            // The pen's forward direction, across which the ribbon lies.
            const Eigen::Vector3f forward =
                Eigen::Quaternionf(orientation.coeffs() / length) * Eigen::Vector3f::UnitZ();
            point.normal = {forward[0], forward[1], -forward[2]};
        }
        for (int bit = 0; bit < 32; ++bit) {
            const std::uint32_t flag = 1u << bit;
            if (!(mask & flag))
                continue;
            const Result<std::uint32_t> value = mBytes.read<std::uint32_t>();
            if (!value)
                return value.error();
            if (flag == Pressure) {
                const float pressure = std::bit_cast<float>(*value);
                bool changed = false;
                stroke.pressure.push_back(inUnit(pressure, changed));
                clampedValues += changed;
                point.halfWidth *= stroke.pressure.back(); // NaN is found by the caller
            } else if (flag == Timestamp) {
                stroke.timeSeconds.push_back(double(*value) / 1000);
            }
        }
        stroke.points.push_back(point);
        return {};
    }

    static bool isUsable(const PaintingFilePoint &point)
    {
        return point.position.allFinite() && point.position.cwiseAbs().maxCoeff() <= largestPosition &&
               point.normal.allFinite() && std::isfinite(point.halfWidth) && std::isfinite(point.opacity);
    }

    BufferedBytes mBytes;
    const Metadata &mMetadata;
    const PaintingReadOptions &mOptions;
};

PaintingFile assembled(SketchReading reading, const Metadata &metadata)
{
    PaintingFile painting;
    painting.kind = PaintingFileKind::Tilt;
    painting.metresPerUnit = 0.1; // decimetres
    PaintingFileLayer root;
    root.name = "Sketch";
    painting.layers.push_back(root);
    for (auto &[index, drawing] : reading.layers) {
        PaintingFileLayer layer;
        if (index < metadata.layers.size())
            layer = metadata.layers[index];
        if (layer.name.empty())
            layer.name = "Layer " + std::to_string(index);
        layer.kind = PaintingFileLayerKind::Paint;
        layer.parent = 0;
        layer.drawings = {std::make_shared<const PaintingFileDrawing>(std::move(drawing))};
        layer.frames = {0};
        painting.layers.push_back(std::move(layer));
    }
    PaintingImportReport &report = painting.report;
    report.layers = int(painting.layers.size());
    report.drawings = report.layers - 1;
    report.strokes = int(reading.strokes);
    report.points = reading.points;
    report.notes = metadata.notes;
    if (const auto &around = metadata.environment) {
        if (standsOutFrom(painting, around->sky))
            painting.background = around->sky;
        else
            report.notes.push_back("the background is not that of the environment \"" + around->name +
                                   "\": the strokes would hardly be seen on it without light");
    }
    if (reading.strokes > 0)
        report.notes.push_back("all brushes were read as ribbons");
    if (reading.clampedValues > 0)
        report.notes.push_back(std::to_string(reading.clampedValues) +
                               " colours or pressures were outside 0..1; they were clamped");
    if (reading.bytesLeft() > 0)
        report.notes.push_back(std::to_string(reading.bytesLeft()) +
                               " bytes after the last stroke were not read");
    return painting;
}

} // namespace

Result<PaintingFile> readTilt(ByteSource &sketch, ByteSource *metadataJson,
                              const PaintingReadOptions &options, const JobControl &control)
{
    Metadata metadata;
    if (metadataJson) {
        Result<Metadata> read = readMetadata(*metadataJson, control.part(0, 0.1));
        if (!read)
            return read.error();
        metadata = std::move(*read);
    } else {
        metadata.notes.push_back("metadata.json is missing: the brushes have no names");
    }
    SketchReading reading(sketch, metadata, options);
    if (const auto error = reading.run(control.part(0.1, 1)))
        return *error;
    return assembled(std::move(reading), metadata);
}

} // namespace ductus
