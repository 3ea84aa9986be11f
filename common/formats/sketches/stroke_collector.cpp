#include "formats/sketches/stroke_collector.h"

namespace ductus {

namespace {

constexpr std::int64_t mostWarnings = 50;

} // namespace

Error tooManyPoints(const TextLines &lines, const std::string &found, int maxPoints)
{
    return lines.error(ErrorCode::TooLarge,
                       found + " where at most " + std::to_string(maxPoints) + " are taken",
                       "Thin the sketch out (fewer points a stroke), split it, or raise the limit");
}

StrokeCollector::StrokeCollector(const TextLines &lines, const SketchReadOptions &options,
                                 SketchFileKind kind)
    : mLines(lines), mMaxPoints(options.maxPoints)
{
    mFile.kind = kind;
}

void StrokeCollector::beginStroke()
{
    endStroke();
    mBeginLine = mLines.lineNumber();
}

std::optional<Error> StrokeCollector::addPoint(const Vec3 &point)
{
    if (++mPointCount > mMaxPoints)
        return tooManyPoints(mLines, "the file has more points", mMaxPoints);
    mPoints.push_back(point);
    return std::nullopt;
}

void StrokeCollector::endStroke()
{
    if (!isInStroke())
        return;
    if (mPoints.size() >= 2)
        addStroke(std::move(mPoints));
    else
        warn(mBeginLine,
             mPoints.empty() ? "a stroke without points was skipped" : "a stroke of one point was skipped");
    mPoints = {};
    mBeginLine = 0;
}

void StrokeCollector::addStroke(std::vector<Vec3> points)
{
    Stroke stroke;
    stroke.id = StrokeId{std::int32_t(mFile.strokes.strokes.size())};
    stroke.points = std::move(points);
    mFile.strokes.strokes.push_back(std::move(stroke));
}

void StrokeCollector::warn(std::int64_t line, const std::string &text)
{
    if (++mWarningCount <= mostWarnings)
        mFile.warnings.push_back(mLines.place(line) + ": " + text);
}

Result<SketchFile> StrokeCollector::finish()
{
    endStroke();
    if (mFile.strokes.strokes.empty())
        return mLines.fileError(ErrorCode::TooLittleData,
                                mWarningCount > 0 ? "no stroke of at least two points is left"
                                                  : "there are no strokes in it",
                                "Draw or export a sketch of several strokes");
    if (mWarningCount > mostWarnings)
        mFile.warnings.push_back(mLines.name() + ": " + std::to_string(mWarningCount - mostWarnings) +
                                 " more warnings of this kind");
    return std::move(mFile);
}

} // namespace ductus
