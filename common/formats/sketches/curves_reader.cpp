#include "formats/sketches/sketch_readers.h"

#include "formats/sketches/stroke_collector.h"
#include "formats/text/number_text.h"

namespace ductus {

namespace {

/// "1 point", "3 points".
std::string points(std::int64_t count)
{
    return std::to_string(count) + (count == 1 ? " point" : " points");
}

Error wrongCount(const TextLines &lines, const StrokeCollector &strokes, std::int64_t announced)
{
    return lines.error(ErrorCode::Malformed,
                       "the stroke that begins at line " + std::to_string(strokes.strokeBeginLine()) +
                           " announces " + points(announced) + " but only " +
                           std::to_string(strokes.strokePointCount()) + " follow",
                       lines.lastLineIsOpen() ? "The file seems cut off: copy or export it again"
                                              : "Correct the count after 'v' or export the file again");
}

/// The N of "v N".
Result<std::int64_t> readCount(const TextLines &lines, std::string_view line,
                               const SketchReadOptions &options)
{
    Words words(line);
    const std::string_view keyword = words.next();
    const std::string_view count = words.next();
    if (keyword != "v")
        return lines.error(ErrorCode::Malformed,
                           "expected 'v' and the number of points of the next stroke, found " +
                               inQuotes(keyword),
                           "Correct the count of the stroke before this line or export the file again");
    if (count.empty())
        return lines.error(ErrorCode::Malformed, "the number of points is missing after 'v'",
                           "Write the number of points of the stroke after 'v'");
    std::int64_t value = 0;
    const NumberFault fault = readInteger(count, value);
    if (fault != NumberFault::None)
        return lines.error(ErrorCode::Malformed, "the number of points " + describeFault(fault, count),
                           "Write the number of points of the stroke after 'v'");
    if (value < 0)
        return lines.error(ErrorCode::Malformed,
                           "the number of points is negative (" + std::to_string(value) + ")",
                           "Write the number of points of the stroke after 'v'");
    if (!words.next().empty())
        return lines.error(ErrorCode::Malformed, "there is more after the number of points",
                           "Give a vertex file as OBJ with 'l' records, or correct this line");
    if (value > options.maxPoints)
        return tooManyPoints(lines, "the stroke announces " + points(value), options.maxPoints);
    return value;
}

} // namespace

Result<SketchFile> readCurves(TextLines &lines, const SketchReadOptions &options, const JobControl &control)
{
    StrokeCollector strokes(lines, options, SketchFileKind::Curves);
    std::int64_t announced = 0;
    bool warnedOfColumns = false;
    std::string_view line;
    while (lines.next(line)) {
        if (const auto stop = lines.tick(control))
            return *stop;
        Words words(line);
        const std::string_view first = words.next();
        if (first.empty() || first[0] == '#')
            continue;
        const bool complete = strokes.strokePointCount() == announced;
        if (complete) {
            const Result<std::int64_t> count = readCount(lines, line, options);
            if (!count)
                return count.error();
            strokes.beginStroke();
            announced = *count;
            continue;
        }
        if (first == "v")
            return wrongCount(lines, strokes, announced);
        Vec3 point;
        words = Words(line);
        if (const auto error = lines.readPoint(words, point, "the point"))
            return *error;
        if (!words.next().empty() && !warnedOfColumns) {
            strokes.warn(lines.lineNumber(), "only the first three numbers of a line are used");
            warnedOfColumns = true;
        }
        if (const auto error = strokes.addPoint(point))
            return *error;
    }
    if (lines.failure())
        return *lines.failure();
    if (strokes.strokePointCount() != announced)
        return wrongCount(lines, strokes, announced);
    return strokes.finish();
}

} // namespace ductus
