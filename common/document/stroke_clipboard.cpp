#include "document/stroke_clipboard.h"

#include "project/json/json_reader.h"
#include "project/json/json_writer.h"

#include <algorithm>
#include <limits>

namespace ductus {

namespace {

constexpr char attempted[] = "Pasting strokes";
constexpr std::size_t mostStrokes = 200'000;
constexpr std::size_t mostPoints = 20'000'000;
constexpr qsizetype mostBytes = 512ll << 20;
constexpr double largest = 1e12;

constexpr std::pair<std::string_view, StrokeRole> roleNames[] = {{"surface", StrokeRole::Surface},
                                                                 {"boundary", StrokeRole::Boundary},
                                                                 {"ignored", StrokeRole::Ignored},
                                                                 {"inner", StrokeRole::Inner},
                                                                 {"skeletal", StrokeRole::Skeletal}};
constexpr std::pair<std::string_view, UpAxis> axisNames[] = {{"y", UpAxis::Y}, {"z", UpAxis::Z}};

template <typename T, std::size_t n>
std::string_view nameOf(const std::pair<std::string_view, T> (&names)[n], T value)
{
    return std::ranges::find(names, value, &std::pair<std::string_view, T>::second)->first;
}

OrderedJson strokeJson(const CopiedStroke &stroke)
{
    OrderedJson points = OrderedJson::array();
    for (const Vec3 &p : stroke.line.points)
        points.push_back({p.x(), p.y(), p.z()});
    OrderedJson json = {{"role", nameOf(roleNames, stroke.line.role)}, {"points", std::move(points)}};
    for (const auto &[key, values] : {std::pair("pressure", &stroke.line.pressure),
                                      {"time", &stroke.line.timeSeconds},
                                      {"halfWidths", &stroke.halfWidths}})
        if (!values->empty())
            json[key] = *values;
    if (stroke.colour)
        json["colour"] = {(*stroke.colour)[0], (*stroke.colour)[1], (*stroke.colour)[2]};
    if (stroke.opacity != 1.0)
        json["opacity"] = stroke.opacity;
    return json;
}

std::string jsonOf(const CopiedStrokes &strokes)
{
    OrderedJson json = {{"schema", "strokes"},
                        {"version", 1},
                        {"metresPerUnit", strokes.metresPerUnit},
                        {"upAxis", nameOf(axisNames, strokes.upAxis)},
                        {"flat", strokes.isFlat},
                        {"strokes", OrderedJson::array()}};
    for (const CopiedStroke &stroke : strokes.strokes)
        json["strokes"].push_back(strokeJson(stroke));
    return json.dump();
}

// As .curves files have them: how many points, then the points.
QByteArray textOf(const CopiedStrokes &strokes)
{
    QByteArray text;
    for (const CopiedStroke &stroke : strokes.strokes) {
        text += "v " + QByteArray::number(qlonglong(stroke.line.points.size())) + '\n';
        for (const Vec3 &p : stroke.line.points)
            text += QByteArray::number(p.x(), 'g', 9) + ' ' + QByteArray::number(p.y(), 'g', 9) + ' ' +
                    QByteArray::number(p.z(), 'g', 9) + '\n';
    }
    return text;
}

std::vector<double> channel(const JsonReader &reader, const char *key, std::size_t count, double least,
                            double most)
{
    if (!reader.has(key))
        return {};
    std::vector<double> values = reader.numbers(key, count);
    for (const double value : values)
        if (value < least || value > most)
            reader.failAt(key, "a value is out of range");
    return values;
}

CopiedStroke strokeFrom(const JsonReader &reader, std::size_t &pointsLeft)
{
    CopiedStroke stroke;
    stroke.line.role = reader.oneOf<StrokeRole>("role", roleNames);
    for (const std::vector<double> &row : reader.rows("points", pointsLeft, 3)) {
        stroke.line.points.emplace_back(row[0], row[1], row[2]);
        if (!(stroke.line.points.back().cwiseAbs().maxCoeff() <= largest))
            reader.failAt("points", "a point is too far away");
    }
    const std::size_t count = stroke.line.points.size();
    if (count == 0)
        reader.failAt("points", "there is none");
    pointsLeft -= std::min(count, pointsLeft);
    stroke.line.pressure = channel(reader, "pressure", count, 0.0, 1.0);
    stroke.line.timeSeconds = channel(reader, "time", count, -largest, largest);
    stroke.halfWidths = channel(reader, "halfWidths", count, 0.0, largest);
    if (const std::vector<double> rgb = channel(reader, "colour", 3, 0.0, 1.0); rgb.size() == 3)
        stroke.colour = Eigen::Vector3d(rgb[0], rgb[1], rgb[2]).cast<float>();
    if (reader.has("opacity"))
        stroke.opacity = reader.number("opacity", 0.0, 1.0);
    return stroke;
}

} // namespace

QString strokesMimeType()
{
    return QStringLiteral("application/vnd.ductus.strokes+json");
}

std::unique_ptr<QMimeData> mimeDataOf(const CopiedStrokes &strokes)
{
    auto data = std::make_unique<QMimeData>();
    data->setData(strokesMimeType(), QByteArray::fromStdString(jsonOf(strokes)));
    data->setText(QString::fromLatin1(textOf(strokes)));
    return data;
}

bool hasStrokes(const QMimeData *data)
{
    return data && data->hasFormat(strokesMimeType());
}

Result<CopiedStrokes> strokesFrom(const QMimeData *data)
{
    if (!hasStrokes(data))
        return Error{ErrorCode::TooLittleData, attempted, "the clipboard holds no strokes",
                     "Copy strokes in an app of the suite first", ""};
    const QByteArray bytes = data->data(strokesMimeType());
    if (bytes.size() > mostBytes)
        return Error{ErrorCode::TooLarge, attempted, "there are too many of them", "Copy fewer strokes", ""};
    const Result<JsonDocument> json = parsedJson(bytes.toStdString(), "clipboard");
    if (!json)
        return json.error();
    const JsonReader reader(*json, "clipboard");
    CopiedStrokes strokes;
    if (reader.string("schema", 64) != "strokes" || reader.integer("version", 1, INT32_MAX) != 1)
        reader.fail("this is no version of strokes that is known here");
    strokes.metresPerUnit = reader.number("metresPerUnit", std::numeric_limits<double>::min(), largest);
    strokes.upAxis = reader.oneOf<UpAxis>("upAxis", axisNames);
    strokes.isFlat = reader.boolean("flat");
    std::size_t pointsLeft = mostPoints;
    for (const JsonReader &one : reader.elements("strokes", mostStrokes)) {
        if (reader.failed())
            break;
        strokes.strokes.push_back(strokeFrom(one, pointsLeft));
    }
    if (reader.failed())
        return reader.error();
    if (strokes.strokes.empty())
        return Error{ErrorCode::TooLittleData, attempted, "the clipboard holds no strokes",
                     "Copy strokes in an app of the suite first", ""};
    return strokes;
}

CopiedStrokes inUnit(CopiedStrokes strokes, double metresPerUnit, UpAxis upAxis)
{
    const double scale = strokes.metresPerUnit / metresPerUnit;
    const bool turns = strokes.upAxis != upAxis;
    for (CopiedStroke &stroke : strokes.strokes) {
        for (Vec3 &p : stroke.line.points) {
            p *= scale;
            if (turns) // about x: what was up is up again
                p = upAxis == UpAxis::Y ? Vec3(p.x(), p.z(), -p.y()) : Vec3(p.x(), -p.z(), p.y());
        }
        for (double &width : stroke.halfWidths)
            width *= scale;
    }
    strokes.metresPerUnit = metresPerUnit;
    strokes.upAxis = upAxis;
    return strokes;
}

} // namespace ductus
