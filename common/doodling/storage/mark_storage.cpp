#include "doodling/storage/mark_storage.h"

#include "formats/png_file.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double largest = 1e12;
constexpr double smallest = 1e-12;
constexpr std::size_t longestText = 100000;

enum class MarkKind { Ink, Area, Text, Arrow, Sticker, Picture };

constexpr std::pair<std::string_view, MarkKind> kindNames[] = {
    {"ink", MarkKind::Ink},     {"area", MarkKind::Area},       {"text", MarkKind::Text},
    {"arrow", MarkKind::Arrow}, {"sticker", MarkKind::Sticker}, {"picture", MarkKind::Picture}};

OrderedJson pair(const Vec2 &v)
{
    return OrderedJson::array({v.x(), v.y()});
}

OrderedJson colourJson(const Rgba &c)
{
    return OrderedJson::array({c[0], c[1], c[2], c[3]});
}

Vec2 pairFrom(const JsonReader &reader, std::string_view key)
{
    const std::vector<double> numbers = reader.numbers(key, 2);
    return reader.failed() ? Vec2(Vec2::Zero()) : Vec2(numbers[0], numbers[1]);
}

Rgba colourFrom(const JsonReader &reader, std::string_view key)
{
    const std::vector<std::uint64_t> numbers = reader.unsignedIntegers(key, 4);
    if (reader.failed())
        return {};
    if (numbers.size() != 4 || *std::max_element(numbers.begin(), numbers.end()) > 255) {
        reader.failAt(key, "it is no colour of four numbers up to 255");
        return {};
    }
    return {std::uint8_t(numbers[0]), std::uint8_t(numbers[1]), std::uint8_t(numbers[2]),
            std::uint8_t(numbers[3])};
}

struct Writer
{
    ArrayPass &pass;

    OrderedJson operator()(const InkStroke &ink) const
    {
        std::vector<double> numbers;
        for (const Vec3 &point : ink.line.points)
            numbers.insert(numbers.end(), {point.x(), point.y(), point.z()});
        const std::uint64_t count = ink.line.points.size();
        OrderedJson json = {{"kind", "ink"}, {"colour", colourJson(ink.colour)}, {"width", ink.width}};
        json["points"] = pass.array<double>(numbers, {count, 3}, "canvas");
        if (!ink.line.pressure.empty())
            json["pressure"] = pass.array<double>(ink.line.pressure, {count});
        if (!ink.line.timeSeconds.empty())
            json["time"] = pass.array<double>(ink.line.timeSeconds, {count}, "s");
        return json;
    }
    OrderedJson operator()(const FilledShape &shape) const
    {
        return {{"kind", "area"},
                {"colour", colourJson(shape.colour)},
                {"outline", planePoints(shape.outline, "canvas", pass)}};
    }
    OrderedJson operator()(const TextMark &text) const
    {
        return {{"kind", "text"},
                {"text", text.text},
                {"place", pair(text.place)},
                {"height", text.height},
                {"turn", text.turn},
                {"bold", text.isBold},
                {"colour", colourJson(text.colour)},
                {"edge", colourJson(text.edge)}};
    }
    OrderedJson operator()(const ArrowMark &arrow) const
    {
        return {{"kind", "arrow"},
                {"colour", colourJson(arrow.colour)},
                {"width", arrow.width},
                {"points", planePoints(arrow.points, "canvas", pass)}};
    }
    OrderedJson operator()(const StickerMark &sticker) const
    {
        return {{"kind", "sticker"},    {"name", sticker.name}, {"place", pair(sticker.place)},
                {"size", sticker.size}, {"turn", sticker.turn}, {"colour", colourJson(sticker.colour)}};
    }
    OrderedJson operator()(const PictureMark &picture) const
    {
        std::vector<std::uint8_t> bytes;
        if (const Result<std::vector<std::byte>> png = encodePng(*picture.image); png)
            for (const std::byte byte : *png)
                bytes.push_back(std::uint8_t(byte));
        return {{"kind", "picture"},
                {"place", pair(picture.place)},
                {"size", pair(picture.size)},
                {"turn", picture.turn},
                {"png", pass.array<std::uint8_t>(bytes, {bytes.size()})}};
    }
};

InkStroke inkFrom(const JsonReader &reader, ArrayLoader &arrays)
{
    InkStroke ink;
    ink.colour = colourFrom(reader, "colour");
    ink.width = reader.number("width", smallest, largest);
    const std::vector<double> numbers = arrays.load<double>(reader, "points", 3);
    for (std::size_t i = 0; i + 3 <= numbers.size(); i += 3)
        ink.line.points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    if (reader.has("pressure"))
        ink.line.pressure = arrays.load<double>(reader, "pressure", 1);
    if (reader.has("time"))
        ink.line.timeSeconds = arrays.load<double>(reader, "time", 1);
    const auto fits = [&](const std::vector<double> &channel) {
        return channel.empty() || channel.size() == ink.line.points.size();
    };
    if (!reader.failed() &&
        (ink.line.points.empty() || !fits(ink.line.pressure) || !fits(ink.line.timeSeconds)))
        reader.fail("the line has no points, or pressures or times for others");
    return ink;
}

PictureMark pictureFrom(const JsonReader &reader, ArrayLoader &arrays)
{
    PictureMark picture;
    picture.place = pairFrom(reader, "place");
    picture.size = pairFrom(reader, "size");
    picture.turn = reader.number("turn", -largest, largest);
    const std::vector<std::uint8_t> bytes = arrays.load<std::uint8_t>(reader, "png", 1);
    if (reader.failed())
        return picture;
    if (!(picture.size.minCoeff() > 0.0))
        reader.failAt("size", "it is not positive");
    Result<Image> image = decodePng(std::as_bytes(std::span(bytes)));
    if (!image)
        reader.failAt("png", "the picture cannot be read: " + image.error().problem);
    else
        picture.image = std::make_shared<const Image>(std::move(*image));
    return picture;
}

TextMark textFrom(const JsonReader &reader)
{
    TextMark text;
    text.text = reader.string("text", longestText);
    text.place = pairFrom(reader, "place");
    text.height = reader.number("height", smallest, largest);
    text.turn = reader.number("turn", -largest, largest);
    text.isBold = reader.boolean("bold");
    text.colour = colourFrom(reader, "colour");
    text.edge = colourFrom(reader, "edge");
    if (!reader.failed() && text.text.empty())
        reader.failAt("text", "there are no words");
    return text;
}

} // namespace

OrderedJson planePoints(const std::vector<Vec2> &points, const char *unit, ArrayPass &pass)
{
    std::vector<double> numbers;
    for (const Vec2 &point : points)
        numbers.insert(numbers.end(), {point.x(), point.y()});
    return pass.array<double>(numbers, {points.size(), 2}, unit);
}

std::vector<Vec2> planePointsFrom(const JsonReader &reader, std::string_view key, ArrayLoader &arrays)
{
    const std::vector<double> numbers = arrays.load<double>(reader, key, 2);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i + 2 <= numbers.size(); i += 2)
        points.emplace_back(numbers[i], numbers[i + 1]);
    return points;
}

OrderedJson markJson(const DoodleMark &mark, ArrayPass &pass)
{
    return std::visit(Writer{pass}, mark);
}

DoodleMark markFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    switch (reader.oneOf<MarkKind>("kind", kindNames)) {
    case MarkKind::Ink:
        return inkFrom(reader, arrays);
    case MarkKind::Area: {
        FilledShape shape;
        shape.colour = colourFrom(reader, "colour");
        shape.outline = planePointsFrom(reader, "outline", arrays);
        if (!reader.failed() && shape.outline.size() < 3)
            reader.failAt("outline", "it has less than three points");
        return shape;
    }
    case MarkKind::Text:
        return textFrom(reader);
    case MarkKind::Arrow: {
        ArrowMark arrow;
        arrow.colour = colourFrom(reader, "colour");
        arrow.width = reader.number("width", smallest, largest);
        arrow.points = planePointsFrom(reader, "points", arrays);
        if (!reader.failed() && arrow.points.size() < 2)
            reader.failAt("points", "it has less than two points");
        return arrow;
    }
    case MarkKind::Sticker: {
        StickerMark sticker;
        sticker.name = reader.string("name", 64);
        sticker.place = pairFrom(reader, "place");
        sticker.size = reader.number("size", smallest, largest);
        sticker.turn = reader.number("turn", -largest, largest);
        sticker.colour = colourFrom(reader, "colour");
        return sticker;
    }
    case MarkKind::Picture:
        return pictureFrom(reader, arrays);
    }
    return TextMark();
}

} // namespace ductus
