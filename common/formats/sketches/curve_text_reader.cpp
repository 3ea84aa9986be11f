#include "formats/sketches/sketch_readers.h"

#include "formats/sketches/stroke_collector.h"
#include "formats/text/number_text.h"

namespace ductus {

Result<SketchFile> readCurveText(TextLines &lines, const SketchReadOptions &options,
                                 const JobControl &control)
{
    StrokeCollector strokes(lines, options, SketchFileKind::CurveText);
    bool warnedOfColumns = false;
    std::string_view line;
    while (lines.next(line)) {
        if (const auto stop = lines.tick(control))
            return *stop;
        Words words(line);
        const std::string_view first = words.next();
        if (first.empty() || first[0] == '#')
            continue;
        if (first == "CURVE") {
            const std::string_view number = words.next();
            std::int64_t index = 0;
            // The index itself is not used (strokes are numbered in file order), but a wrong one tells of
            // damage.
            if (!number.empty() && readInteger(number, index) != NumberFault::None)
                return lines.error(ErrorCode::Malformed, "the number after CURVE is " + inQuotes(number),
                                   "Write 'CURVE' and an integer before each stroke");
            strokes.beginStroke();
            continue;
        }
        if (!strokes.isInStroke())
            return lines.error(ErrorCode::Malformed,
                               "there is " + inQuotes(first) + " before the first CURVE line",
                               "Write 'CURVE 0' before the first point");
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
    return strokes.finish();
}

} // namespace ductus
