#include "formats/sketches/sketch_readers.h"

#include "formats/sketches/segment_chains.h"
#include "formats/sketches/stroke_collector.h"
#include "formats/text/number_text.h"
#include "formats/text/obj_index.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace ductus {

namespace {

/// What the records say, before segments are chained.
struct ObjRecords
{
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> polylines; // "l" records of three or more indices: strokes as they are
    std::vector<Segment> segments;           // "l" records of two different indices: to be chained
    std::int64_t polylinePoints = 0;
    std::int64_t faces = 0;
};

/// Records that say nothing about lines.
bool isKnownObjRecord(std::string_view keyword)
{
    static constexpr std::array<std::string_view, 33> known = {
        "vn",     "vt",     "vp",     "g",          "o",         "s",     "mg",       "p",        "mtllib",
        "usemtl", "usemap", "maplib", "shadow_obj", "trace_obj", "bevel", "c_interp", "d_interp", "lod",
        "cstype", "deg",    "bmat",   "step",       "curv",      "curv2", "surf",     "parm",     "trim",
        "hole",   "scrv",   "sp",     "end",        "con",       "call"};
    return std::find(known.begin(), known.end(), keyword) != known.end();
}

class ObjLinesReader
{
public:
    ObjLinesReader(TextLines &lines, const SketchReadOptions &options)
        : mLines(lines), mMaxPoints(options.maxPoints), mStrokes(lines, options, SketchFileKind::ObjLines)
    {
    }

    Result<SketchFile> read(const JobControl &control);

private:
    std::optional<Error> readRecord(std::string_view line);
    std::optional<Error> readVertex(Words &words);
    std::optional<Error> readLine(Words &words);
    void joinCoincidentVertices();
    void dropRepeatedSegments();
    Result<SketchFile> strokesFromRecords();

    TextLines &mLines;
    std::int64_t mMaxPoints;
    StrokeCollector mStrokes;
    ObjRecords mRecords;
    bool mWarnedOfRecord = false;
};

std::optional<Error> ObjLinesReader::readVertex(Words &words)
{
    if (std::int64_t(mRecords.vertices.size()) >= mMaxPoints)
        return tooManyPoints(mLines, "the file has more points", int(mMaxPoints));
    Vec3 vertex;
    if (const auto error = mLines.readPoint(words, vertex, "the vertex"))
        return error;
    mRecords.vertices.push_back(vertex);
    return std::nullopt;
}

std::optional<Error> ObjLinesReader::readLine(Words &words)
{
    std::vector<int> indices;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const Result<int> index = readObjIndex(word, std::int64_t(mRecords.vertices.size()), mLines);
        if (!index)
            return index.error();
        indices.push_back(*index);
        if (mRecords.polylinePoints + std::int64_t(indices.size()) > mMaxPoints)
            return tooManyPoints(mLines, "the 'l' records have more points", int(mMaxPoints));
    }
    if (indices.empty())
        return mLines.error(ErrorCode::Malformed, "there are no vertex indices after 'l'",
                            "Correct this line or export the file again");
    if (indices.size() == 1) {
        mStrokes.warn(mLines.lineNumber(), "a stroke of one point was skipped");
    } else if (indices.size() == 2) {
        if (std::int64_t(mRecords.segments.size()) >= mMaxPoints)
            return tooManyPoints(mLines, "the file has more line segments", int(mMaxPoints));
        if (indices[0] == indices[1])
            mStrokes.warn(mLines.lineNumber(), "a line from a point to itself was skipped");
        else
            mRecords.segments.push_back({indices[0], indices[1]});
    } else {
        mRecords.polylinePoints += std::int64_t(indices.size());
        mRecords.polylines.push_back(std::move(indices));
    }
    return std::nullopt;
}

std::optional<Error> ObjLinesReader::readRecord(std::string_view line)
{
    Words words(line);
    const std::string_view keyword = words.next();
    if (keyword.empty() || keyword[0] == '#')
        return std::nullopt;
    if (keyword == "v")
        return readVertex(words);
    if (keyword == "l")
        return readLine(words);
    if (keyword == "f" || keyword == "fo") {
        ++mRecords.faces;
        return std::nullopt;
    }
    if (isKnownObjRecord(keyword))
        return std::nullopt;
    const bool isWord = std::all_of(keyword.begin(), keyword.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    double number = 0.0;
    if (!isWord || readNumber(keyword, number) == NumberFault::None)
        return mLines.error(ErrorCode::Malformed, inQuotes(keyword) + " is no OBJ record",
                            "Correct this line or export the file again");
    if (!mWarnedOfRecord)
        mStrokes.warn(mLines.lineNumber(),
                      "the record " + inQuotes(keyword) + " is not known and was skipped");
    mWarnedOfRecord = true;
    return std::nullopt;
}

/// Exporters that give each segment its own two vertices repeat the shared ones bit for bit.
void ObjLinesReader::joinCoincidentVertices()
{
    const std::vector<Vec3> &vertices = mRecords.vertices;
    const auto key = [&](int v) {
        const Vec3 &p = vertices[std::size_t(v)];
        return std::array<double, 3>{p.x(), p.y(), p.z()};
    };
    std::vector<int> order(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<int> representative(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
        representative[std::size_t(order[i])] = same ? representative[std::size_t(order[i - 1])] : order[i];
    }
    for (Segment &segment : mRecords.segments)
        for (int &vertex : segment)
            vertex = representative[std::size_t(vertex)];
    std::erase_if(mRecords.segments, [](const Segment &s) { return s[0] == s[1]; });
}

/// A segment written twice would make every vertex along it look like a junction.
void ObjLinesReader::dropRepeatedSegments()
{
    std::vector<Segment> &segments = mRecords.segments;
    const auto key = [&](std::size_t s) {
        return Segment{std::min(segments[s][0], segments[s][1]), std::max(segments[s][0], segments[s][1])};
    };
    std::vector<std::size_t> order(segments.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<char> repeated(segments.size(), 0);
    std::size_t count = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (key(order[i]) == key(order[i - 1])) {
            repeated[order[i]] = 1;
            ++count;
        }
    if (count == 0)
        return;
    std::vector<Segment> kept;
    kept.reserve(segments.size() - count);
    for (std::size_t s = 0; s < segments.size(); ++s)
        if (!repeated[s])
            kept.push_back(segments[s]);
    segments = std::move(kept);
    mStrokes.warn(mLines.lineNumber(),
                  std::to_string(count) + " line segments were there twice and were skipped");
}

Result<SketchFile> ObjLinesReader::strokesFromRecords()
{
    // In a file with polylines a two-index record may be a stroke of its own, so there only shared indices
    // join.
    if (mRecords.polylines.empty()) {
        joinCoincidentVertices();
        dropRepeatedSegments();
    }
    const auto addStroke = [&](const std::vector<int> &indices) {
        std::vector<Vec3> points;
        points.reserve(indices.size());
        for (int index : indices)
            points.push_back(mRecords.vertices[std::size_t(index)]);
        mStrokes.addStroke(std::move(points));
    };
    for (const auto &polyline : mRecords.polylines)
        addStroke(polyline);
    std::int64_t points = mRecords.polylinePoints;
    for (const auto &chain : chainSegments(mRecords.segments, mRecords.vertices)) {
        points += std::int64_t(chain.size());
        if (points > mMaxPoints)
            return tooManyPoints(mLines, "the strokes have more points", int(mMaxPoints));
        addStroke(chain);
    }
    return mStrokes.finish();
}

Result<SketchFile> ObjLinesReader::read(const JobControl &control)
{
    std::string_view line;
    while (mLines.next(line, true)) {
        if (const auto stop = mLines.tick(control))
            return *stop;
        if (const auto error = readRecord(line))
            return *error;
    }
    if (mLines.failure())
        return *mLines.failure();
    const bool hasLines = !mRecords.polylines.empty() || !mRecords.segments.empty();
    if (mRecords.faces > 0 && !hasLines)
        return mLines.fileError(ErrorCode::Unsupported,
                                "this is a mesh: it has " + std::to_string(mRecords.faces) +
                                    " faces and no lines",
                                "Give it as the proxy (--proxy), and a file with 'l' records as the sketch");
    if (mRecords.faces > 0)
        mStrokes.warn(mLines.lineNumber(), std::to_string(mRecords.faces) + " faces were ignored");
    return strokesFromRecords();
}

} // namespace

Result<SketchFile> readObjLines(TextLines &lines, const SketchReadOptions &options, const JobControl &control)
{
    return ObjLinesReader(lines, options).read(control);
}

} // namespace ductus
