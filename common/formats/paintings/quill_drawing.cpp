#include "formats/paintings/quill_drawing.h"

#include <array>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the painting";
constexpr std::size_t strokeHeaderSize = 40;
constexpr std::size_t pointSize = 56;
constexpr float largestPosition = 1e18f; // squares stay finite in single precision

// Points are read in one piece into their structs.
static_assert(sizeof(PaintingFilePoint) == pointSize && std::is_standard_layout_v<PaintingFilePoint>);
static_assert(offsetof(PaintingFilePoint, normal) == 12 && offsetof(PaintingFilePoint, viewDirection) == 24 &&
              offsetof(PaintingFilePoint, colour) == 36 && offsetof(PaintingFilePoint, opacity) == 48 &&
              offsetof(PaintingFilePoint, halfWidth) == 52);

struct StrokeHeader
{
    std::uint32_t id;
    std::uint32_t zero;
    float box[6]; // never trusted
    std::int16_t brush;
    std::uint8_t disableRotationalOpacity;
    std::uint8_t padding;
    std::uint32_t pointCount;
};
static_assert(sizeof(StrokeHeader) == strokeHeaderSize && std::endian::native == std::endian::little);

Error malformedAt(const std::string &place, std::string problem)
{
    return {ErrorCode::Malformed, attempted, std::move(problem),
            "Copy the project again, or save it again in Quill", place};
}

PaintingFileSection sectionOf(int brush, QuillDrawingTally &tally)
{
    switch (brush) {
    case 1:
        return PaintingFileSection::Ribbon;
    case 3:
        return PaintingFileSection::Ellipse;
    case 4:
        return PaintingFileSection::Cube;
    case 2:
        break;
    default:
        ++tally.unknownBrushes;
    }
    return PaintingFileSection::Round;
}

bool clampTo(float &value, float low, float high)
{
    const float clamped = std::min(std::max(value, low), high);
    const bool changed = clamped != value;
    value = clamped;
    return changed;
}

/// False if a number is not finite or beyond all bounds.
bool checkPoint(PaintingFilePoint &point, QuillDrawingTally &tally)
{
    if (!(point.position.cwiseAbs().maxCoeff() <= largestPosition) || !point.position.allFinite() ||
        !point.normal.allFinite() || !point.viewDirection.allFinite() || !point.colour.allFinite() ||
        !std::isfinite(point.opacity) || !(std::abs(point.halfWidth) <= largestPosition))
        return false;
    if (point.normal.cwiseAbs().maxCoeff() > largestPosition ||
        point.viewDirection.cwiseAbs().maxCoeff() > largestPosition)
        return false;
    bool changed = clampTo(point.opacity, 0, 1);
    changed |= clampTo(point.halfWidth, 0, largestPosition);
    for (int c = 0; c < 3; ++c)
        changed |= clampTo(point.colour[c], 0, 1);
    tally.clampedValues += changed;
    return true;
}

Result<PaintingFileStroke> readStroke(BufferedBytes &bytes, QuillDrawingTally &tally)
{
    const std::uint64_t begin = bytes.offset();
    StrokeHeader header{};
    if (const Result<void> done = bytes.read(std::as_writable_bytes(std::span(&header, 1))); !done)
        return done.error();
    if (header.pointCount > bytes.remaining() / pointSize)
        return malformedAt(bytes.source().place(begin + strokeHeaderSize - 4),
                           "a stroke of " + std::to_string(header.pointCount) +
                               " points is announced, but the file ends before");
    tally.points += header.pointCount;
    if (tally.points > tally.maxPoints)
        return Error{ErrorCode::TooLarge, attempted,
                     "the painting has more than " + std::to_string(tally.maxPoints) + " points",
                     "Split it in Quill, or read only the first frame", bytes.source().place(begin)};
    PaintingFileStroke stroke;
    stroke.id = header.id;
    stroke.section = sectionOf(header.brush, tally);
    stroke.fadesSeenFromAside = header.disableRotationalOpacity == 0;
    const std::uint64_t firstPoint = bytes.offset();
    stroke.points.resize(header.pointCount);
    if (const Result<void> done = bytes.read(std::as_writable_bytes(std::span(stroke.points))); !done)
        return done.error();
    for (std::size_t i = 0; i < stroke.points.size(); ++i)
        if (!checkPoint(stroke.points[i], tally))
            return malformedAt(bytes.source().place(firstPoint + i * pointSize),
                               "point " + std::to_string(i) + " of a stroke has a number that is not finite");
    return stroke;
}

} // namespace

Result<QuillDrawingRead> readQuillDrawing(ByteSource &qbin, std::uint64_t offset, QuillDrawingTally &tally,
                                          const JobControl &control)
{
    BufferedBytes bytes(qbin, offset);
    const Result<std::uint32_t> count = bytes.read<std::uint32_t>();
    if (!count)
        return count.error();
    if (*count > bytes.remaining() / strokeHeaderSize)
        return malformedAt(qbin.place(offset), "a drawing of " + std::to_string(*count) +
                                                   " strokes is announced, but the file ends before");
    QuillDrawingRead read;
    for (std::uint32_t s = 0; s < *count; ++s) {
        if (control.isCancelled())
            return cancelledError(attempted);
        Result<PaintingFileStroke> stroke = readStroke(bytes, tally);
        if (!stroke)
            return stroke.error();
        read.drawing.strokes.push_back(std::move(*stroke));
    }
    read.end = bytes.offset();
    return read;
}

Result<Image> readQuillPicture(ByteSource &qbin, std::uint64_t offset, std::int64_t maxPixels)
{
    BufferedBytes bytes(qbin, offset);
    std::array<std::uint8_t, 8> kind{};
    if (const Result<void> done = bytes.read(std::as_writable_bytes(std::span(kind))); !done)
        return done.error();
    std::array<std::uint32_t, 3> sizes{}; // width, height, 1
    if (const Result<void> done = bytes.read(std::as_writable_bytes(std::span(sizes))); !done)
        return done.error();
    const std::array<std::uint8_t, 8> known{0, 0, 0, 1, 2, kind[5], 0, 0};
    if (kind != known || (kind[5] != 6 && kind[5] != 7) || sizes[2] != 1)
        return Error{ErrorCode::Unsupported, attempted, "the picture is of a layout that is not known", "",
                     qbin.place(offset)};
    const std::uint64_t channels = kind[5] == 7 ? 4 : 3;
    const std::uint64_t pixels = std::uint64_t(sizes[0]) * sizes[1]; // < 2^64
    if (pixels == 0 || pixels > std::uint64_t(maxPixels) || sizes[0] > 1 << 20 || sizes[1] > 1 << 20)
        return Error{ErrorCode::Unsupported, attempted,
                     "the picture of " + std::to_string(sizes[0]) + " x " + std::to_string(sizes[1]) +
                         " pixels is empty or too large",
                     "", qbin.place(offset)};
    if (pixels > bytes.remaining() / channels)
        return malformedAt(qbin.place(offset), "the picture reaches beyond the end of the file");
    Image image{int(sizes[0]), int(sizes[1])};
    std::vector<std::uint8_t> row(std::size_t(sizes[0]) * channels);
    for (int y = 0; y < image.height; ++y) {
        if (const Result<void> done = bytes.read(std::as_writable_bytes(std::span(row))); !done)
            return done.error();
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t *p = row.data() + std::size_t(x) * channels;
            image.set(x, y, {p[0], p[1], p[2], channels == 4 ? p[3] : std::uint8_t(255)});
        }
    }
    return image;
}

} // namespace ductus
