#include "formats/sketches/sketch_readers.h"

#include "formats/sketches/point_order.h"
#include "formats/sketches/stroke_collector.h"

namespace ductus {

namespace {

/// One block of points that do not follow one another: each becomes a "stroke" of its own.
void scatter(SketchFile &file)
{
    std::vector<Vec3> points = std::move(file.strokes.strokes.front().points);
    file.strokes.strokes.clear();
    file.strokes.strokes.reserve(points.size());
    for (const Vec3 &point : points) {
        Stroke stroke;
        stroke.id = StrokeId{std::int32_t(file.strokes.strokes.size())};
        stroke.points = {point};
        file.strokes.strokes.push_back(std::move(stroke));
    }
    file.isPointCloud = true;
}

} // namespace

Result<SketchFile> readXyz(TextLines &lines, const SketchReadOptions &options, const JobControl &control)
{
    StrokeCollector strokes(lines, options, SketchFileKind::Xyz);
    bool warnedOfColumns = false;
    std::string_view line;
    while (lines.next(line)) {
        if (const auto stop = lines.tick(control))
            return *stop;
        Words words(line);
        const std::string_view first = words.next();
        if (first.empty()) {
            strokes.endStroke();
            continue;
        }
        if (first[0] == '#')
            continue;
        Vec3 point;
        words = Words(line);
        if (const auto error = lines.readPoint(words, point, "the point"))
            return *error;
        if (!words.next().empty() && !warnedOfColumns) {
            strokes.warn(lines.lineNumber(), "only the first three numbers of a line are used");
            warnedOfColumns = true;
        }
        if (!strokes.isInStroke())
            strokes.beginStroke();
        if (const auto error = strokes.addPoint(point))
            return *error;
    }
    if (lines.failure())
        return *lines.failure();
    Result<SketchFile> file = strokes.finish();
    // Blank lines say where strokes end, so only a file that is one block can be a cloud.
    if (file && file->strokes.strokes.size() == 1 && isUnordered(file->strokes.strokes.front().points))
        scatter(*file);
    return file;
}

} // namespace ductus
